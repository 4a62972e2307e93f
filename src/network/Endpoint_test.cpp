#include "network/Endpoint.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Endpoint, IsAPortOrAnAddressAndAPort) {
  const auto read = [](std::string_view text) {
    const auto endpoint = parseEndpoint(text);
    return endpoint ? endpoint->address + " " + std::to_string(endpoint->port) : "";
  };
  EXPECT_EQ(read("3838"), "127.0.0.1 3838");
  EXPECT_EQ(read("0.0.0.0:0"), "0.0.0.0 0");
  EXPECT_EQ(read("[::1]:65535"), "::1 65535");
  for (const char* wrong : {"", "here", "65536", "10.0.0.1", ":1", "10.0.0.1:", "-1", "1 "})
    EXPECT_EQ(read(wrong), "") << wrong;
  EXPECT_EQ(parseEndpoint("x").error().text(), "x: expected a port, or ADDRESS:PORT");
}

}  // namespace
}  // namespace gt
