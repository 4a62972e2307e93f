#include "simulation/scene/ModelNames.h"

#include <gtest/gtest.h>

#include "simulation/scene/Xml.h"

namespace gt {
namespace {

std::string prefixed(const std::string& element, bool asset = false) {
  const XmlDocument document = parseXml(element);
  prefixNames(xmlDocGetRootElement(document.get()), {"red1/", "robot/"}, asset);
  std::string text = xmlText(*document);
  text.erase(0, text.find('\n') + 1);
  text.pop_back();
  return text;
}

TEST(ModelNames, ThingsAndAssetsHavePrefixesOfTheirOwn) {
  EXPECT_EQ(prefixed(R"(<geom name="a" class="b" material="c" mesh="d"/>)"),
            R"(<geom name="red1/a" class="robot/b" material="robot/c" mesh="robot/d"/>)");
  EXPECT_EQ(prefixed(R"(<material name="c" texture="t"/>)", true),
            R"(<material name="robot/c" texture="robot/t"/>)");
  EXPECT_EQ(prefixed(R"(<exclude body1="a" body2="b"/>)"),
            R"(<exclude body1="red1/a" body2="red1/b"/>)");
  EXPECT_EQ(prefixed(R"(<framepos objtype="site" objname="a" reftype="body" refname="b"/>)"),
            R"(<framepos objtype="site" objname="red1/a" reftype="body" refname="red1/b"/>)");
  EXPECT_EQ(prefixed(R"(<element objtype="mesh" objname="a"/>)"),
            R"(<element objtype="mesh" objname="robot/a"/>)");
  EXPECT_EQ(prefixed(R"(<composite type="rope"/>)"), R"(<composite type="rope" prefix="red1/"/>)");
}

TEST(ModelNames, TheMainClassIsTheFiles) {
  EXPECT_EQ(prefixed(R"(<geom class="main"/>)"), R"(<geom class="robot/main"/>)");
  EXPECT_EQ((ModelPrefixes{"", ""}.mainClass()), "/main");
  const XmlDocument document = parseXml(
      R"(<contact><pair geom1="a" geom2="b"/><pair class="c"/><exclude body1="a" body2="b"/></contact>)");
  xmlNode* section = xmlDocGetRootElement(document.get());
  setMainClass(section, {"red1/", "robot/"});
  const auto contacts = elementsOf(section);
  EXPECT_EQ(attribute(contacts[0], "class"), "robot/main");
  EXPECT_EQ(attribute(contacts[1], "class"), "c");
  EXPECT_EQ(attribute(contacts[2], "class"), "");
}

TEST(ModelNames, AnElementsClassMayBeThatOfABodyAroundIt) {
  const XmlDocument document =
      parseXml(R"(<body childclass="a"><geom class="b"/><body><geom/></body></body>)");
  std::string classes;
  forEachElement(xmlDocGetRootElement(document.get()), [&](const xmlNode* node) {
    if (nameOf(node) == "geom") classes += classOf(node);
  });
  EXPECT_EQ(classes, "ba");
}

}  // namespace
}  // namespace gt
