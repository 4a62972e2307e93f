#include "xabsl/tools/server/XmlScan.h"

#include <gtest/gtest.h>

#include <string>

namespace xabsl::server {
namespace {

/// All elements: "name=label ", with a point for each element around it.
std::string treeOf(std::string_view text) {
  const XmlScan scan = scanXml(text);
  std::string tree;
  for (const ScannedElement& element : scan.elements) {
    for (int around = element.parent; around >= 0;
         around = scan.elements[static_cast<std::size_t>(around)].parent)
      tree += '.';
    tree += std::string{element.name} + "=" + std::string{element.label} + " ";
  }
  return tree;
}

TEST(XmlScan, FindsElementsAndTheirNames) {
  EXPECT_EQ(treeOf("<?xml version='1.0'?><!DOCTYPE a [<!ENTITY b SYSTEM 'c'>]>"
                   "<x:option name = 'a>b'><state initial='no' id=\"s\"/>&b;<!-- <state> "
                   "--></x:option><agent/>"),
            "option=a .state=s agent= ");
  EXPECT_EQ(treeOf("<a><![CDATA[<b>]]></a>"), "a= ");
  const std::string_view text = "<a>\n <b id='x'>\n </b>\n</a>\n";
  const XmlScan scan = scanXml(text);
  ASSERT_EQ(scan.elements.size(), 2u);
  const ScannedElement& b = scan.elements[1];
  EXPECT_EQ(text.substr(b.begin, b.end - b.begin), "<b id='x'>\n </b>");
  EXPECT_EQ(text.substr(b.labelAt, 1), "x");
}

TEST(XmlScan, GoesOnBehindWhatIsMissing) {
  EXPECT_EQ(treeOf("<option name='a'><state name='b'><if><state name='c'></state></option>"),
            "option=a .state=b ..if= .state=c ")
      << "ends";
  EXPECT_EQ(treeOf("<option name='a'><state name='b\n<if/></state><state name='c'/></option>"),
            "option=a .state=b ..if= .state=c ")
      << "a quote";
  EXPECT_EQ(treeOf("<option name='a'></if></state><state name='b'/></option></option>"),
            "option=a .state=b ")
      << "begins";
  EXPECT_EQ(
      treeOf("<symbols id='s'><constant name='c'<enumeration name='e'><enum-element name='f'/>"),
      "symbols=s .constant=c .enumeration=e ..enum-element=f ");
  EXPECT_EQ(
      treeOf(
          "<option name='a'><state name='b'><set-enumerated-output-symbol/><x/></state></option>"),
      "option=a .state=b ..set-enumerated-output-symbol= ..x= ");
  const std::string_view open = "<state name='b'>\n<!-- typed\n<state name='c'>";
  const XmlScan scan = scanXml(open);
  ASSERT_EQ(scan.elements.size(), 2u);
  EXPECT_EQ(open.substr(0, scan.elements[0].end), "<state name='b'>\n<!-- typed");
}

TEST(XmlScan, IsBoundedForAnyText) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  for (int i = 0; i < 100'000; ++i) deep += "</b>";
  EXPECT_EQ(scanXml(deep).elements.size(), 400u);
  std::string many;
  for (int i = 0; i < 400'000; ++i) many += "<a/>";
  EXPECT_EQ(scanXml(many).elements.size(), 300'000u);
  EXPECT_TRUE(scanXml("<").elements.empty());
}

}  // namespace
}  // namespace xabsl::server
