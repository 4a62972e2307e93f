#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "streams/Type.h"

namespace gt {

/// The definition of a message of a log or of the network, in the language of ROS 2 (`ros2msg`).
struct Schema {
  std::string name;  ///< As in gt2003_msgs/msg/BallModel.
  std::string text;

  /// Hash of name and text; equal schemas have the same id.
  std::uint32_t id() const { return hashOf(text, hashOf(name)); }
};

namespace detail {
Schema schemaOf(const Type& type);
}

/// The schema that is derived from a type's fields: names in ROS's spelling (lastSeen is
/// last_seen); units, sentences and ranges as comments; enumerations as uint8 with constants;
/// arrays inside of arrays or lists as messages of their own. A type may define its own schema,
/// `T::schema()`.
template <Streamable T>
Schema schemaOf() {
  if constexpr (requires { T::schema(); })
    return T::schema();
  else
    return detail::schemaOf(typeOf<T>());
}

/// A name in the spelling that ROS demands for fields: lastSeen is last_seen.
std::string snakeCase(std::string_view name);
/// Converts a text to upper case.
std::string upperCase(std::string_view text);

/// A point in time as ROS 2 has it (builtin_interfaces/Time).
struct RosTime {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  static RosTime of(Time time);

  static constexpr auto fields() {
    return Fields{field<&RosTime::sec>(Unit::s), field<&RosTime::nanosec>(Unit::ns)};
  }
};

/// Time and frame of reference of a measurement (std_msgs/Header).
struct RosHeader {
  RosTime stamp;
  std::string frameId;

  static constexpr auto fields() {
    return Fields{field<&RosHeader::stamp>(), field<&RosHeader::frameId>()};
  }
};

/// An image as JPEG or PNG, in the form that viewers know (sensor_msgs/CompressedImage).
struct CompressedImage {
  RosHeader header;
  std::string format = "jpeg";
  std::vector<std::uint8_t> data;

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field<&CompressedImage::header>(), field<&CompressedImage::format>("jpeg or png"),
                  field<&CompressedImage::data>()};
  }
};

}  // namespace gt
