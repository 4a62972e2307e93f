#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <algorithm>

#include "Failure.h"
#include "Tools.h"
#include "colors/ColorOrder.h"
#include "colors/ColorStatistics.h"
#include "colors/ColorTableEditor.h"
#include "colors/ColorTableFile.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

using Bytes = nb::ndarray<const std::uint8_t, nb::c_contig, nb::device::cpu>;

ColorClass colorClassOf(int number) {
  if (number < 0 || number >= static_cast<int>(enumCount<ColorClass>))
    refuse("color class", "there is none of this number: " + std::to_string(number));
  return static_cast<ColorClass>(number);
}

std::optional<ColorClass> selectedClass(std::optional<int> number) {
  if (!number) return std::nullopt;
  return colorClassOf(*number);
}

nb::object toArray(const ColorTable64& table) {
  auto* const data = new std::vector<ColorClass>(table.classes.begin(), table.classes.end());
  const nb::capsule owner{
      data, [](void* p) noexcept { delete static_cast<std::vector<ColorClass>*>(p); }};
  const std::size_t shape[] = {64, 64, 64};
  return nb::ndarray<nb::numpy, std::uint8_t>(data->data(), 3, shape, owner).cast();
}

ColorTable64 toTable(const Bytes& classes) {
  if (classes.ndim() != 3 || classes.shape(0) != 64 || classes.shape(1) != 64 ||
      classes.shape(2) != 64)
    refuse("table", "expected an array of shape (64, 64, 64)");
  ColorTable64 table;
  std::transform(classes.data(), classes.data() + classes.size(), table.classes.begin(),
                 &colorClassOf);
  return table;
}

ColorTable64 read(const std::string& file, const std::string& order) {
  const auto tableOf = [](const auto& colors) { return colors.table(); };
  if (file.ends_with(".hsi")) return tableOf(orThrow(readHsiColors(file)));
  if (file.ends_with(".tsl")) return tableOf(orThrow(readTslColors(file)));
  if (!file.ends_with(".c64"))
    throw Failure{Error{.file = file, .what = "expected a name that ends with .c64, .hsi or .tsl"}};
  if (order != "gt2003" && order != "nao2009") refuse("order", "must be gt2003 or nao2009");
  const ColorTable64 table =
      orThrow(order == "gt2003" ? readColorTable(file) : readColorTable(file, nao2009ColorOrder));
  const bool nao2009 = order == "nao2009";
  const std::string doubt =
      doubtOfOrder(table, file, nao2009, nao2009 ? "order='gt2003'" : "order='nao2009'");
  if (!doubt.empty() && PyErr_WarnEx(PyExc_UserWarning, doubt.c_str(), 1) != 0)
    throw nb::python_error{};
  return table;
}

void addImage(ColorStatistics& statistics, const Bytes& image, const Bytes& classes) {
  if (image.ndim() != 3 || image.shape(2) != 3)
    refuse("image", "expected an array of shape (height, width, 3)");
  if (classes.ndim() != 2 || classes.shape(0) != image.shape(0) ||
      classes.shape(1) != image.shape(1))
    refuse("classes", "expected an array of the image's height and width");
  constexpr std::size_t largest = 1u << 14;
  if (image.shape(0) > largest || image.shape(1) > largest)
    refuse("image", "is larger than 16384 pixels a side");
  Image whole;
  whole.info.height = static_cast<int>(image.shape(0));
  whole.info.width = static_cast<int>(image.shape(1));
  whole.pixels.resize(classes.size());
  const std::uint8_t* channel = image.data();
  for (Pixel& pixel : whole.pixels) {
    pixel.y = *channel++;
    pixel.cb = *channel++;
    pixel.cr = *channel++;
  }
  std::vector<ColorClass> labels(classes.size());
  std::transform(classes.data(), classes.data() + classes.size(), labels.begin(), &colorClassOf);
  statistics.add(whole, labels);
}

double shareOf(double share) {
  if (!(share > 0 && share <= 1)) refuse("share", "must be above 0, and at most 1");
  return share;
}

int within(const char* name, int value, int low, int high) {
  if (value < low || value > high)
    refuse(name, "must be from " + std::to_string(low) + " to " + std::to_string(high));
  return value;
}

void bindStatistics(nb::module_& module) {
  nb::class_<ColorStatistics>(
      module, "ColorStatistics",
      "How often each color was seen in each class, in images whose classes are known.")
      .def(nb::init<>())
      .def("add", &addImage, "image"_a, "classes"_a,
           "Counts an image (height, width, 3), uint8, YCbCr, with the class of each pixel "
           "(height,\n"
           "width), uint8: `Robot.image` and the first of `Robot.labels`. Pixels beside another\n"
           "class do not count.")
      .def(
          "table",
          [](const ColorStatistics& self, int growth, int leastPixels) {
            return toArray(self.table(
                within("growth", growth, 0, 63),
                static_cast<std::uint32_t>(within("least_pixels", leastPixels, 1, 1 << 30))));
          },
          "growth"_a = 0, "least_pixels"_a = 2,
          "The class that most pixels of each color have, if 70 % do; colors never seen take that\n"
          "of their neighbors if these agree, in so many steps. (64, 64, 64), uint8.")
      .def(
          "hsi",
          [](const ColorStatistics& self, double share) {
            return hsiText(self.hsi(shareOf(share)));
          },
          "share"_a = 0.95,
          "The text of a .hsi file: ranges that hold this share of each class's pixels.")
      .def(
          "tsl",
          [](const ColorStatistics& self, double share) {
            return tslText(self.tsl(shareOf(share)));
          },
          "share"_a = 0.95,
          "The text of a .tsl file: thresholds that hold this share of each class's pixels.");
}

}  // namespace

void bindColors(nb::module_& module) {
  bindStatistics(module);
  module.def("_read_colors", [](const std::string& file, const std::string& order) {
    return toArray(read(file, order));
  });
  module.def("_color_bytes", [](const Bytes& classes) {
    const std::string bytes = colorTableBytes(toTable(classes));
    return nb::bytes(bytes.data(), bytes.size());
  });
  nb::class_<ColorTableEditor>(module, "ColorTableEditor",
                               "Makes a color table step by step. A class is a\n"
                               "`representations.ColorClass`, a color (Y, Cb, Cr).")
      .def(
          "__init__",
          [](ColorTableEditor* self, const std::optional<Bytes>& table) {
            new (self) ColorTableEditor{table ? toTable(*table) : ColorTable64{}};
          },
          "table"_a = nb::none())
      .def_prop_ro(
          "table", [](const ColorTableEditor& self) { return toArray(self.table()); },
          "A copy: (64, 64, 64), uint8.")
      .def(
          "set",
          [](ColorTableEditor& self, std::uint8_t y, std::uint8_t cb, std::uint8_t cr,
             int colorClass) { self.set({.y = y, .cb = cb, .cr = cr}, colorClassOf(colorClass)); },
          "y"_a, "cb"_a, "cr"_a, "color_class"_a, "Assigns a class to a color.")
      .def(
          "clear",
          [](ColorTableEditor& self, int colorClass) { self.clear(colorClassOf(colorClass)); },
          "color_class"_a, "Takes all its colors from a class.")
      .def("reset", &ColorTableEditor::reset, "Takes all colors from all classes.")
      .def(
          "remove_isolated",
          [](ColorTableEditor& self, std::optional<int> colorClass) {
            self.removeIsolated(selectedClass(colorClass));
          },
          "color_class"_a = nb::none(),
          "Removes colors that have none of their class among their 26 neighbors.")
      .def(
          "median",
          [](ColorTableEditor& self, int neighbors, int distance, bool reassign,
             std::optional<int> colorClass) {
            self.median({within("neighbors", neighbors, 1, 1 << 20),
                         within("distance", distance, 1, 8), reassign},
                        selectedClass(colorClass));
          },
          "neighbors"_a = 6, "distance"_a = 1, "reassign"_a = false, "color_class"_a = nb::none(),
          "Adds the colors to a class, or to each, that have so many of its colors near.")
      .def("undo", &ColorTableEditor::undo, "Takes the last step back; False if there is none.");
}

}  // namespace gt::python
