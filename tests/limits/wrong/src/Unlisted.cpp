#include <sys/socket.h>

long unlisted(int socket, char* bytes) {
  return recv(socket, bytes, 10, 0);
}
