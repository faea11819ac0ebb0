#pragma once
/// @file
/// Parts that are inside out or lie wrongly in others, and places where the surface passes through
/// itself, with what they cost: as lines along the three axes see them. In words.

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "tumble/mesh/check_parts.hpp"
#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/crossing_size.hpp"

namespace tumble::detail {

/// "going up the line x = 1, y = 2", or along another axis.
inline std::string describe_line(const LineHit& hit) {
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

/// What a wrong depth looks like to somebody who goes along the line.
inline std::string describe_wrong_depth(const WrongDepth& wrong) {
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

/// "; 1.6e-04 ± 2e-05 of the volume count wrongly".
inline std::string describe_share(double share, double uncertainty) {
  std::array<char, 80> text;
  std::snprintf(text.data(), text.size(), "; %.2g ± %.1g of the volume count wrongly", share,
                uncertainty);
  return text.data();
}

/// The piece of a line where the depth is wrong for longest; null if `counts` lets none pass.
template <class Counts>
const WrongDepth* longest_of(const std::vector<WrongDepth>& all, const Counts& counts) {
  const WrongDepth* longest = nullptr;
  for (const WrongDepth& wrong : all)
    if (counts(wrong) && (longest == nullptr || wrong.length > longest->length)) longest = &wrong;
  return longest;
}

/// All pieces of the lines of a bundle where the depth is wrong.
inline std::vector<WrongDepth> all_wrong_depths(const LineBundle& bundle) {
  std::vector<WrongDepth> all;
  bundle.for_each([&](const LineHits& hits) {
    const std::vector<WrongDepth> some = find_wrong_depths(hits);
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

/// "faces #3 and #40 pass through each other at about (1, 2, 3)".
inline std::string describe_meeting(const TriangleMeeting& meeting) {
  std::ostringstream text;
  text.precision(9);
  const Vec3& p = meeting.crossing.place;
  text << "the surface passes through itself: faces #" << meeting.faces[0] + 1 << " and #"
       << meeting.faces[1] + 1 << " meet at about (" << p.x() << ", " << p.y() << ", " << p.z()
       << ")";
  return text.str();
}

/// What lines along the axes, and pairs of triangles if they are looked for, are asked about.
struct CrossingQuestion {
  const PolygonMesh& mesh;
  const Components& surface;
  const Eigen::AlignedBox3d& box;  ///< around all vertices
  const LineLattices& lattices;
  const TrianglesNearLines& near;  ///< triangles that may meet a line of the lattices
  bool also_touching;              ///< whether places where triangles only touch are looked at
  std::optional<double> rounding;  ///< of the coordinates, as they were written [m], if it is known

  LineBundle hits(double blur) const {
    return hits_of_bundle(mesh, surface, box, lattices, near, blur);
  }
  double volume() const {
    double sum = 0;
    for (const Component& part : surface.parts) sum += part.volume;
    return std::abs(sum);
  }
  double written() const { return rounding ? *rounding : coordinate_rounding(mesh); }
};

/// The finding of a crossing that is there: what it looks like, and its share.
/// @param longest the longest piece of a line with a wrong depth, or null
inline MeshDefect crossing_defect(const CrossingQuestion& of, const CrossingEvidence& evidence,
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

/// Which parts are inside out or nested wrongly, and how much counts wrongly because the surface
/// crosses itself.
/// @param blur what is no deeper than rounding by so much makes it is no crossing [m]
inline std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of,
                                                TriangleMeetings meetings, double blur) {
  meetings.forgive(blur);
  CrossingEvidence evidence{of.hits(blur), false, std::move(meetings)};
  const std::vector<WrongDepth> wrong = all_wrong_depths(evidence.bundle);
  const auto& [through, touching] = evidence.meetings;
  const bool suspicious = !wrong.empty() || !through.empty() || of.also_touching;
  if (!of.also_touching) evidence.meetings.touching.clear();
  evidence.is_seen = !wrong.empty();
  const bool one_looks_inwards = std::any_of(of.surface.parts.begin(), of.surface.parts.end(),
                                             [](const Component& part) { return part.volume < 0; });
  if (!suspicious && !one_looks_inwards) return {};
  const std::vector<PartDepth> depths = measure_parts(evidence.bundle, of.surface);
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
  const WrongVolume found = wrong_volume(of.mesh, of.surface, of.box, evidence, blur, counts);
  if (longest != nullptr || found.volume > 0)
    findings.push_back(crossing_defect(of, evidence, longest, found));
  return findings;
}

/// Whether a surface crosses itself by more than what may pass as rounding.
inline bool counts_too_much(const std::vector<MeshDefect>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const MeshDefect& finding) { return finding.share > rounding_share; });
}

/// The crossings of a known share, as notes.
inline std::vector<MeshDefect> as_rounding(const std::vector<MeshDefect>& findings) {
  std::vector<MeshDefect> notes;
  for (const MeshDefect& finding : findings) {
    if (finding.kind != MeshDefectKind::self_crossing || std::isnan(finding.share)) continue;
    notes.push_back(finding);
    notes.back().may_be_rounding = true;
    notes.back().message = "perhaps because the last digit is rounded, " + finding.message;
  }
  return notes;
}

/// The same; what rounding of the file's last decimal may have done is a note, as long as it counts
/// little. A body far away, or one that was written with few digits, may lose much by it.
inline std::vector<MeshDefect> find_wrong_depth(const CrossingQuestion& of,
                                                const TriangleMeetings& meetings) {
  const double blur = double_blur(of.box);
  std::vector<MeshDefect> findings = find_wrong_depth(of, meetings, blur);
  if (findings.empty() || counts_too_much(findings)) return findings;
  const double written = of.written();
  if (!(written > blur)) return findings;
  std::vector<MeshDefect> left = find_wrong_depth(of, meetings, written);
  return left.empty() ? as_rounding(findings) : left;
}

}  // namespace tumble::detail
