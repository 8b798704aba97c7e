#include "run_picture.h"

#include <algorithm>
#include <cmath>

#include "format.h"
#include "picture_file.h"

namespace cli {

namespace {

/// The section, where all but one in two hundred lie, and a tenth of that on either side: a grain that flew far ahead
/// must not make the slope small.
struct Range {
  double low, high;
  bool holds(double v) const { return v >= low && v <= high; }
};
Range range_of_most(const std::vector<double>& place, std::size_t axis, const picture::Polyline& section) {
  std::vector<double> sorted;
  for (std::size_t i = axis; i < place.size(); i += 2) sorted.push_back(place[i]);
  std::sort(sorted.begin(), sorted.end());
  const std::size_t few = sorted.size() / 200;
  const double low = sorted[few], high = sorted[sorted.size() - 1 - few], room = (high - low) / 10;
  Range range{low - room, high + room};
  for (const picture::Point& corner : section) {
    const double v = axis == 0 ? corner.x : corner.y;
    range = {std::min(range.low, v), std::max(range.high, v)};
  }
  return range;
}

}  // namespace

picture::Sheet run_sheet(const Scene& scene, const vbgpd_model* model, const RunResult& result) {
  constexpr double kPi = 3.14159265358979323846;
  picture::Sheet sheet = section_sheet(scene);
  const Sample last = result.series.empty() ? Sample{} : result.series.back();
  const double time = last.time < 1e-6 ? 0 : last.time;
  sheet.result =
      format("t = %s s, run-out %s m", plain_number(time, 3).c_str(), plain_number(last.runout_distance, 3).c_str());
  std::string unseen;
  if (time > 0) {  // they move with the ground: arrows and a line would stand where it was
    if (!sheet.loads.empty()) unseen += ", loads";
    if (!sheet.water.empty()) unseen += ", water pressures";
    sheet.loads.clear(), sheet.water.clear();
  }
  sheet.full_strain = 1;  // the same in every frame of an animation
  const std::vector<double> place = field(model, "position"), strain = field(model, "plastic_strain");
  const std::vector<double> volume = field(model, "volume"), material = field(model, "material");
  const Range across = range_of_most(place, 0, sheet.exterior), up = range_of_most(place, 1, sheet.exterior);
  std::int64_t outside = 0;
  for (std::size_t i = 0; i < volume.size(); ++i) {
    if (!across.holds(place[2 * i]) || !up.holds(place[2 * i + 1])) {
      ++outside;
      continue;
    }
    sheet.grains.push_back(
        {place[2 * i], place[2 * i + 1], std::sqrt(volume[i] / kPi) * 1.12, strain[i], static_cast<int>(material[i])});
  }
  if (outside > 0) sheet.remark = counted(outside, "loose particle") + " farther away";
  sheet.footer = "Method: " + result.scheme + "; flow rule " + result.flow_rule + "; strength reduction factor " +
                 plain_number(result.factor, 4) + "; viscosity " + plain_number(result.viscosity, 3) +
                 " m2/s. Spacing " + plain_number(result.spacing, 3) + " m, " + counted(result.particles, "particle") +
                 ". The line is the section before" +
                 (unseen.empty() ? "" : "; not drawn, but acting on the soil:" + unseen.substr(1)) + ". vbgpd " +
                 vbgpd_version_string();
  return sheet;
}

}  // namespace cli
