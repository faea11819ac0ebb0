#pragma once

#include "tumble/mesh/check_crossing.hpp"

#include <array>
#include <sstream>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/check_parts.hpp"

namespace tumble::detail {

TUMBLE_BODY std::string describe_line(const LineHit& hit) {
  std::ostringstream text;
  text.precision(9);
  if (hit.view.axis == 2)
    text << "going up the line ";
  else
    text << "going along " << hit.view.name(2) << " on the line ";
  text << hit.view.name(0) << " = " << hit.line.x() << ", " << hit.view.name(1) << " = "
       << hit.line.y();
  return text.str();
}

TUMBLE_BODY std::string describe_wrong_depth(const WrongDepth& wrong) {
  std::ostringstream text;
  text.precision(9);
  const auto place = [&](const LineHit& hit) {
    std::ostringstream at;
    at.precision(9);
    at << hit.view.name(2) << " = " << hit.z << " (face #" << hit.face + 1 << ")";
    return at.str();
  };
  text << "the surface passes through itself: " << describe_line(wrong.here);
  if (wrong.depth < 0)
    text << ", you leave the body at " << place(wrong.here) << " without having entered it";
  else
    text << ", you enter the body at " << place(wrong.before) << " and again at "
         << place(wrong.here) << " without leaving it in between; what lies "
         << (wrong.here.view.axis == 2 ? "above" : "behind") << " counts " << wrong.depth
         << " times";
  return text.str();
}

TUMBLE_BODY std::string describe_share(double share, double uncertainty) {
  std::array<char, 80> text;
  std::snprintf(text.data(), text.size(), "; %.2g ± %.1g of the volume count wrongly", share,
                uncertainty);
  return text.data();
}

TUMBLE_BODY std::vector<WrongDepth> all_wrong_depths(const LineBundle& bundle) {
  std::vector<WrongDepth> all;
  bundle.for_each([&](const LineHits& hits) {
    const std::vector<WrongDepth> some = find_wrong_depths(hits);
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

TUMBLE_BODY std::string describe_meeting(const TriangleMeeting& meeting) {
  std::ostringstream text;
  text.precision(9);
  const Vec3& p = meeting.crossing.place;
  text << "the surface passes through itself: faces #" << meeting.faces[0] + 1 << " and #"
       << meeting.faces[1] + 1 << " meet at about (" << p.x() << ", " << p.y() << ", " << p.z()
       << ")";
  return text.str();
}

TUMBLE_BODY MeshDefect crossing_defect(const CrossingQuestion& of, const CrossingEvidence& evidence,
                                       const WrongDepth* longest, const WrongVolume& found) {
  const auto& meetings =
      evidence.meetings.through.empty() ? evidence.meetings.touching : evidence.meetings.through;
  MeshDefect crossing{.kind = MeshDefectKind::self_crossing,
                      .face = longest ? longest->here.face : meetings.front().faces[0]};
  crossing.message = longest ? describe_wrong_depth(*longest) : describe_meeting(meetings.front());
  const double share = found.volume / of.volume(), uncertainty = found.uncertainty / of.volume();
  if (!std::isfinite(share) || !std::isfinite(uncertainty)) return crossing;  // of no volume
  crossing.share = share;
  crossing.share_uncertainty = uncertainty;
  crossing.message += describe_share(share, uncertainty);
  return crossing;
}

TUMBLE_BODY std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of,
                                                     TriangleMeetings meetings,
                                                     const LineBundle& bundle, double blur) {
  meetings.forgive(blur);
  const std::vector<WrongDepth> wrong = all_wrong_depths(bundle);
  const auto& [through, touching] = meetings;
  const bool suspicious = !wrong.empty() || !through.empty() || of.also_touching;
  if (!of.also_touching) meetings.touching.clear();
  const CrossingEvidence evidence{bundle, wrong, meetings};
  const bool one_looks_inwards = std::any_of(of.surface.parts.begin(), of.surface.parts.end(),
                                             [](const Component& part) { return part.volume < 0; });
  if (!suspicious && !one_looks_inwards) return {};
  const std::vector<PartDepth> depths = measure_parts(bundle, of.surface);
  std::vector<MeshDefect> findings = find_wrong_parts(of.mesh, of.surface, depths, blur);
  const auto crosses = [&](const LineHit& hit) {
    const PartDepth& depth = depths[static_cast<std::size_t>(hit.part)];
    return depth.crosses_itself || depth.crosses_another();
  };
  const auto counts = [&, unexplained = findings.empty()](const WrongDepth& place) {
    return unexplained || crosses(place.here) || crosses(place.before);
  };
  const WrongDepth* const longest = longest_of(wrong, counts);
  if (longest == nullptr && (!wrong.empty() || (through.empty() && touching.empty())))
    return findings;
  SearchedMesh on(of.mesh, of.surface, of.box, blur);
  const WrongVolume found = wrong_volume(on, evidence, counts);
  if (longest != nullptr || found.volume > 0 || !through.empty())
    findings.push_back(crossing_defect(of, evidence, longest, found));
  return findings;
}

TUMBLE_BODY double longest_run(const LineHits& hits) {
  double longest = 0, run = 0, end = 0;
  std::size_t line = hits.line_count();
  for (const WrongDepth& wrong : find_wrong_depths(hits)) {
    const bool goes_on = wrong.line == line && wrong.here.z - wrong.here.error <= end;
    run = (goes_on ? run : 0) + wrong.length;
    line = wrong.line;
    end = wrong.here.z + wrong.length + wrong.here.error;
    longest = std::max(longest, run);
  }
  return longest;
}

TUMBLE_BODY LineList lines_around(const std::vector<WrongDepth>& wrong, const View& view,
                                  const Eigen::AlignedBox3d& box) {
  constexpr int n = 64;                // along each side
  constexpr double spacing = 1.0 / n;  // of the lines that were drawn first
  Eigen::AlignedBox3d known;
  for (const WrongDepth& piece : wrong)
    for (const double end : {0., 1.}) known.extend(piece.place(end));
  const Vec3 margin = 2 * spacing * box.sizes();
  known = view.box({known.min() - margin, known.max() + margin});
  std::vector<PlanePoint> lines;
  lines.reserve(wrong.size() + n * n);
  for (const WrongDepth& piece : wrong) lines.emplace_back(view.point(piece.place(0.5)).head<2>());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec3 part((i + 0.5) * spacing, (j + 0.5) * spacing, 0);
      lines.emplace_back((known.min() + part.cwiseProduct(known.sizes())).head<2>());
    }
  return {known, std::move(lines)};
}

TUMBLE_BODY bool is_in_thin_layers(const CrossingQuestion& of, const std::vector<WrongDepth>& wrong,
                                   double thickness) {
  if (wrong.empty()) return false;
  const auto is_thin_along = [&](int axis) {
    const View view{axis};
    // What rounding of the file may have done is no excuse here: the thickness is measured.
    const LinesOnMesh what{of.mesh, of.surface, view, double_blur(of.box)};
    return longest_run(hits_of_lines(what, lines_around(wrong, view, of.box))) <= thickness;
  };
  return is_thin_along(0) || is_thin_along(1) || is_thin_along(2);
}

TUMBLE_BODY bool only_crosses(const std::vector<MeshDefect>& findings) {
  return std::all_of(findings.begin(), findings.end(), [](const MeshDefect& finding) {
    return finding.kind == MeshDefectKind::self_crossing && std::isfinite(finding.share);
  });
}

TUMBLE_BODY bool none_deeper(TriangleMeetings meetings, double blur) {
  meetings.forgive(blur);
  return meetings.through.empty();
}

TUMBLE_BODY std::vector<MeshDefect> as_rounding(const std::vector<MeshDefect>& findings) {
  std::vector<MeshDefect> notes;
  for (const MeshDefect& finding : findings) {
    if (finding.kind != MeshDefectKind::self_crossing || std::isnan(finding.share)) continue;
    notes.push_back(finding);
    notes.back().may_be_rounding = true;
    notes.back().message = "perhaps because the last digit is rounded, " + finding.message;
  }
  return notes;
}

TUMBLE_BODY std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of,
                                                     const TriangleMeetings& meetings,
                                                     const LineBundle& lines) {
  const double blur = double_blur(of.box);
  std::vector<MeshDefect> findings = find_wrong_depth(of, meetings, lines, blur);
  if (findings.empty() || counts_too_much(findings, rounding_share_of_floats)) return findings;
  const double written = of.written();
  if (!(written > blur) || counts_too_much(findings, excused_share(of, written))) return findings;
  const LineBundle rounded = of.hits(written);
  std::vector<MeshDefect> left = find_wrong_depth(of, meetings, rounded, written);
  // Two faces that touched lie no deeper in each other than both were moved.
  const bool thin = only_crosses(left) && none_deeper(meetings, written) &&
                    is_in_thin_layers(of, all_wrong_depths(rounded), 2 * (written + blur));
  return left.empty() || thin ? as_rounding(findings) : left;
}

}  // namespace tumble::detail
