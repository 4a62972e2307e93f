#include "simulation/scene/ProfileTable.h"

#include <type_traits>

namespace gt {
namespace {

constexpr std::string_view measured = "measured in the four ERS-7 images";
constexpr std::string_view estimated = "estimated";
constexpr std::string_view chosen = "chosen by `realism.*`";
constexpr std::string_view swaying = "as in the dynamic fidelity, `realism.sway`";

// perfect, benign, padova, rough
constexpr ProfileNumber table[] = {
    {"", "audience", {{0, 0, 12, 24}}, "report 3.3.2.5: many people were on the field"},
    {"noise",
     "joints",
     {{0, 0.2, 0.2, 0.4}},
     "estimated; most of a joint's error is play and zero"},
    {"noise", "acceleration", {{0, 200, 300, 600}}, estimated},
    {"noise", "psd", {{0, 10, 20, 40}}, estimated},
    {"noise", "slip", {{0, 0.06, 0.08, 0.16}}, chosen},
    {"noise", "motion", {{0, 1, 4.2, 8.4}}, chosen},
    {"noise", "psdReflections", {{0, 0, 0.02, 0.04}}, estimated},
    {"body", "tilt", {{0, 0, 0.3, 0.6}}, chosen},
    {"body", "roll", {{0, 0, 0.25, 0.5}}, chosen},
    {"body", "jointOffset", {{0, 0, 0.4, 0.8}}, chosen},
    {"body", "accelerationOffset", {{0, 0, 200, 400}}, estimated},
    {"body", "cameraLight", {{0, 0, 0.05, 0.1}}, estimated},
    {"body", "cameraColor", {{0, 0, 2, 4}}, "estimated; that cameras differ: facts, 5 (UNSW)"},
    {"body", "backlash", {{0, 0, 0.8, 1.6}}, estimated},
    {"body",
     "commandDelay",
     {{0, 0, 16, 32}},
     "half of the 32 ms that a buffer of joint commands lasts (facts, 1.3)"},
    {"body", "swayTilt", {{0, 0, 0.62, 1.24}}, swaying},
    {"body", "swayRoll", {{0, 0, 1.2, 2.4}}, swaying},
    {"body", "swayHeight", {{0, 0, 0.68, 1.36}}, swaying},
    {"walking", "shortfall", {{0, 0, -0.03, 0}}, swaying},
    {"walking", "gaitShortfall", {{0, 0, 0, 0}}, swaying},
    {"walking", "bursts", {{0, 0, 3, 6}}, swaying},
    {"walking", "burstTime", {{0.5, 0.5, 0.5, 1}}, estimated},
    {"walking", "burstSlip", {{0, 0.5, 0.5, 1}}, estimated},
    {"walking", "contactTurn", {{0, 0, 20, 40}}, estimated},
    {"walking", "contactLag", {{0, 0, 0.5, 0.7}}, estimated},
    {"walking",
     "contactShaking",
     {{0, 0, 3000, 4000}},
     "as in the dynamic fidelity, `worldmodel.collisions`"},
    {"camera", "rollingShutter", {{0, 1, 1, 1}}, "facts, 1.3: a CMOS sensor"},
    {"camera", "blur", {{0, 0.6, 0.83, 1.66}}, measured},
    {"camera", "vignetting", {{0, 0.2, 0.4, 0.8}}, measured},
    {"camera", "noiseY", {{0, 3, 0.8, 1.6}}, measured},
    {"camera", "noiseCb", {{0, 2, 1.7, 3.4}}, measured},
    {"camera", "noiseCr", {{0, 2, 1.2, 2.4}}, measured},
    {"camera", "exposure", {{0, 0, 10, 20}}, "facts, 1.3: 1/100 s by default"},
    {"camera", "noiseGrowth", {{0, 0, 1, 1}}, "measured in the four ERS-7 images; no more can be"},
    {"camera", "noiseCorrelation", {{0, 0, 0.2, 0.4}}, measured},
    {"camera", "chromaBlur", {{0, 0, 0.6, 1.2}}, measured},
    {"camera", "rimCb", {{0, 0, 16, 32}}, measured},
    {"camera", "rimCr", {{0, 0, 2, 4}}, measured},
    {"camera", "unevenLight", {{0, 0, 0.15, 0.3}}, estimated},
    {"camera", "delay", {{0, 0, 10, 20}}, "estimated; that there is one: report 3.3.3.1"},
    {"camera", "delayJitter", {{0, 0, 4, 8}}, "estimated; that there is one: report 3.3.3.1"},
    {"physics", "dents", {{0, 0, 60, 120}}, "estimated; that there are some: report 4.1.3"},
    {"physics", "dentSize", {{150, 150, 150, 150}}, estimated},
    {"radio", "delayMin", {{0, 40, 40, 80}}, estimated},
    {"radio", "delayMax", {{0, 120, 200, 400}}, estimated},
    {"radio", "loss", {{0, 0.05, 0.1, 0.2}}, estimated},
    {"radio", "bursts", {{0, 0, 4, 8}}, "estimated; that it broke down: report 6.1"},
    {"radio", "burstTime", {{2, 2, 4, 8}}, "estimated; that it broke down: report 6.1"},
    {"radio", "burstLoss", {{1, 1, 1, 1}}, "estimated; that it broke down: report 6.1"}};

template <typename T>
void setNumber(T& object, std::string_view name, double value) {
  forEachField(object, [&](const auto& f, auto& member) {
    if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(member)>>)
      if (f.name == name) member = static_cast<std::remove_cvref_t<decltype(member)>>(value);
  });
}

}  // namespace

std::span<const ProfileNumber> profileTable() {
  return table;
}

void setProfile(SceneDescription& scene, Profile profile) {
  scene.profile = profile;
  for (const ProfileNumber& number : table) {
    const double value = number.values[profile];
    if (number.element.empty()) setNumber(scene, number.name, value);
    forEachProfileElement(scene, [&](std::string_view element, auto& parameters) {
      if (element == number.element) setNumber(parameters, number.name, value);
    });
  }
}

}  // namespace gt
