#pragma once
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"
#include "debug/Drawing.h"
#include "match/MatchSummary.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// Writes match.json: the fields of `MatchSummary` in their order, one element of a list a line.
/// The same summary gives the same bytes.
Result<void> writeMatchJson(const std::string& path, const MatchSummary& summary);

/// Writes times.json in the same format.
Result<void> writeTimesJson(const std::string& path, const MatchTimes& times);

/// A camera image, enlarged, with the drawings in the space of the image painted on it.
ReportPicture reportPicture(std::string title, const Image& image,
                            std::span<const Drawing> drawings, int scale = 2);

/// Writes a match as one self-contained page of HTML (data, style, plots, images) that opens
/// offline. It takes about 0.3 MB, 20 kB for each minute, and 30 kB for each image.
Result<void> writeReport(const std::string& path, const MatchSummary& summary,
                         const MatchTimes& times, const std::vector<ReportPicture>& pictures,
                         const FieldDimensions& field = {});

}  // namespace gt
