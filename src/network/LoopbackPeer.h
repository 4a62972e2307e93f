#pragma once

namespace gt {

/// Whether a TCP connection goes over the loopback device.
bool isOverLoopback(int socket);
/// Whether the program at the other end of a connection over the loopback device is of this user or
/// the administrator, as /proc/net/tcp says: any user of a machine reaches its loopback ports.
bool isPeerOfThisUser(int socket);

}  // namespace gt
