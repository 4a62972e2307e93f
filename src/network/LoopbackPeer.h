#pragma once

namespace gt {

/// Whether a TCP connection goes over the loopback device.
bool isOverLoopback(int socket);
/// Whether the program at the other end of a loopback connection belongs to this user or the
/// administrator, according to /proc/net/tcp. The check is needed because all users of a machine
/// can connect to its loopback ports.
bool isPeerOfThisUser(int socket);

}  // namespace gt
