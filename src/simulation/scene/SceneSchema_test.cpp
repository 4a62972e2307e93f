// scenes/scene.xsd is made from the fields of the parameters, so that the schema, with which
// editors complete and check, allows what the loader allows.
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <libxml/xmlschemas.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <span>

#include "base/File.h"
#include "simulation/scene/Scene.h"
#include "simulation/scene/Xml.h"
#include "streams/Type.h"

namespace gt {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string{c};
  return result;
}

std::string enumerations(std::span<const std::string_view> names) {
  std::string text;
  for (const auto name : names) text += fmt::format("<xs:enumeration value=\"{}\"/>", name);
  return text;
}

/// What the loader checks beside the fields' ranges.
std::string restrictionOf(std::string_view name, const Type& type, const Range& range) {
  constexpr std::array<std::string_view, 2> booleans{"true", "false"};
  if (type.kind == Kind::boolean)
    return "<xs:restriction base=\"xs:string\">" + enumerations(booleans);
  if (type.kind == Kind::enumeration)
    return "<xs:restriction base=\"xs:string\">" + enumerations(type.names);
  if (name == "address")
    return "<xs:restriction base=\"xs:string\"><xs:pattern value=\"[0-9A-F]{12}\"/>";
  if (type.kind == Kind::text)
    return "<xs:restriction base=\"xs:string\"><xs:minLength value=\"1\"/>";
  const bool whole = type.number != Number::float64;
  std::string text = fmt::format("<xs:restriction base=\"xs:{}\">", whole ? "integer" : "double");
  const double high = name == "width" || name == "height" ? maxImageSize : range.high;
  if (range.bounds())
    text += fmt::format("<xs:minInclusive value=\"{}\"/><xs:maxInclusive value=\"{}\"/>", range.low,
                        high);
  return text;
}

template <typename T>
std::string attributesOf() {
  std::string text;
  T object{};
  forEachField(object, [&](const auto& f, auto& member) {
    text += fmt::format("    <xs:attribute name=\"{}\">", f.name);
    const std::string unit =
        f.unit.empty() ? "" : std::string{f.unit} + (f.doc.empty() ? "" : ": ");
    if (!(unit.empty() && f.doc.empty()))
      text += "<xs:annotation><xs:documentation>" + escaped(unit + std::string{f.doc}) +
              "</xs:documentation></xs:annotation>\n      ";
    text += "<xs:simpleType>" + restrictionOf(f.name, *valueOf(member).type, f.range) +
            "</xs:restriction></xs:simpleType></xs:attribute>\n";
  });
  return text;
}

template <typename T>
std::string typeNamed(const std::string& name) {
  return "  <xs:complexType name=\"" + name + "\">\n" + attributesOf<T>() + "  </xs:complexType>\n";
}

template <typename T>
std::string groupOf(const std::string& name, const std::string& element, std::size_t most) {
  return typeNamed<T>(element) +
         fmt::format(
             "  <xs:complexType name=\"{}\">\n    <xs:sequence>\n      <xs:element name=\"{}\" "
             "type=\"{}\" minOccurs=\"0\" maxOccurs=\"{}\"/>\n    </xs:sequence>\n  "
             "</xs:complexType>\n",
             name, element, element, most);
}

std::string sceneSchema() {
  const std::map<std::string, std::string> elements{
      {"balls", "balls"},         {"body", "body"},
      {"camera", "camera"},       {"ceilingCamera", "ceilingCamera"},
      {"challenge", "challenge"}, {"dynamics", "dynamics"},
      {"extras", "robots"},       {"game", "game"},
      {"noise", "noise"},         {"optics", "optics"},
      {"physics", "physics"},     {"radio", "radio"},
      {"robots", "robots"},       {"rules", "rules"},
      {"walking", "walking"}};
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!-- Scenes of the simulator (report I.4). Made by "
      "src/simulation/scene/SceneSchema_test.cpp "
      "from the fields of Scene.h:\n     GT_WRITE_SCHEMA=1 gt_simulation_test "
      "-->\n"
      "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n"
      "  <xs:element name=\"scene\">\n    <xs:complexType>\n      <xs:all>\n";
  for (const auto& [name, type] : elements)
    text +=
        fmt::format("        <xs:element name=\"{}\" type=\"{}\" minOccurs=\"0\"/>\n", name, type);
  text += "      </xs:all>\n" + attributesOf<SceneDescription>() +
          "    </xs:complexType>\n  </xs:element>\n";
  text += typeNamed<NoiseParameters>("noise") + typeNamed<BodyParameters>("body") +
          typeNamed<WalkingParameters>("walking") + typeNamed<DynamicsParameters>("dynamics") +
          typeNamed<CameraEffects>("camera") + typeNamed<CeilingCameraParameters>("ceilingCamera") +
          typeNamed<ChallengeParameters>("challenge") + typeNamed<CameraInfo>("optics") +
          typeNamed<BallParameters>("physics") + typeNamed<RadioParameters>("radio") +
          typeNamed<GameParameters>("game") + typeNamed<RuleParameters>("rules");
  text += groupOf<SceneRobot>("robots", "robot", maxSceneRobots) +
          groupOf<SceneBall>("balls", "ball", maxSceneBalls);
  return text + "</xs:schema>\n";
}

/// Validates by the schema of the repository.
class Validator {
 public:
  Validator()
      : parser_{xmlSchemaNewParserCtxt("scenes/scene.xsd")}, schema_{xmlSchemaParse(parser_)} {}
  ~Validator() {
    xmlSchemaFree(schema_);
    xmlSchemaFreeParserCtxt(parser_);
  }
  bool accepts(const std::string& file) const {
    const auto document = readXml(file, "scene");
    xmlSchemaValidCtxt* valid = xmlSchemaNewValidCtxt(schema_);
    xmlSchemaSetValidStructuredErrors(
        valid, [](void*, xmlErrorPtr) {}, nullptr);
    const bool accepted = document && xmlSchemaValidateDoc(valid, document->get()) == 0;
    xmlSchemaFreeValidCtxt(valid);
    return accepted;
  }

 private:
  xmlSchemaParserCtxt* parser_;
  xmlSchema* schema_;
};

TEST(SceneSchema, IsMadeFromTheFields) {
  if (std::getenv("GT_WRITE_SCHEMA")) {
    ASSERT_TRUE(writeFile("scenes/scene.xsd", sceneSchema()));
  }
  EXPECT_TRUE(*readFile("scenes/scene.xsd") == sceneSchema())
      << "write it anew with GT_WRITE_SCHEMA=1";
}

TEST(SceneSchema, AcceptsTheScenesOfTheRepository) {
  const Validator validator;
  for (const auto& entry : std::filesystem::directory_iterator{"scenes"})
    if (entry.path().extension() == ".scene") {
      EXPECT_TRUE(validator.accepts(entry.path().string())) << entry.path();
    }
}

TEST(SceneSchema, AgreesWithTheLoader) {
  const Validator validator;
  const std::string file = testing::TempDir() + "agree.scene";
  int accepted = 0;
  for (const char* text : {"<body tilt=\"21\"/>",
                           "<walking bursts=\"-1\"/>",
                           "<noise slip=\"0.9\"/>",
                           "<noise slip=\"0.95\"/>",
                           "<camera blur=\"2.5\"/>",
                           "<camera vignetting=\"0.9\"/>",
                           "<optics width=\"1281\"/>",
                           "<optics width=\"320\"/>",
                           "<game minutes=\"0\"/>",
                           "<game minutes=\"1e5\"/>",
                           "<game referee=\"maybe\"/>",
                           "<rules shots=\"0\"/>",
                           "<rules shots=\"1.5\"/>",
                           "<rules shots=\"3\"/>",
                           "<robots><robot address=\"12\"/></robots>",
                           "<robots><robot address=\"00022D1F626B\"/></robots>",
                           "<robots><robot role=\"coach\"/></robots>",
                           "<robots><robot model=\"\"/></robots>",
                           "<balls><ball x=\"10001\"/></balls>",
                           "<balls><ball/><bell/></balls>",
                           "<ballz/>"}) {
    ASSERT_TRUE(writeFile(file, std::string{"<scene>"} + text + "</scene>"));
    const auto scene = loadScene(file);
    EXPECT_EQ(validator.accepts(file), static_cast<bool>(scene))
        << text << ": " << (scene ? "loaded" : scene.error().text());
    accepted += static_cast<bool>(scene);
  }
  EXPECT_EQ(accepted, 5);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gt
