// SPDX-License-Identifier: GPL-2.0-or-later
// The scene of a page: frames, quantised and compressed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/picture.h"
#include "io/tables/json.h"
#include "report/packed_bytes.h"
#include "report/quantised.h"
#include "report/scene_frame.h"

namespace mikromakro {

struct SceneOptions {
  std::vector<int> bulk_types;  ///< as in PictureStyle
  double height = 0;            ///< thickness (m); 0: not known, pressures are forces per length (N/m)
  double time_step = 0;         ///< s, > 0: gives the times of frames
};

/// What a scene spans; frames are added first for this, then packed.
class SceneRanges {
 public:
  explicit SceneRanges(SceneOptions options);

  void add(const Frame& frame);

  const SceneOptions& options() const { return options_; }
  /// By column; none for columns without any number.
  std::vector<std::optional<Quantiser>> disc_quantisers() const;
  std::vector<std::optional<Quantiser>> contact_quantisers() const;
  /// Window, force scale, columns with their resolutions, and the quantities that discs can be coloured by,
  /// with the limits of `mikromakro draw`.
  Json description() const;

 private:
  Json quantities() const;

  SceneOptions options_;
  std::vector<Limits> discs_, contacts_;  // by column
  std::vector<PictureScales> scales_;     // by quantity
  double radii_ = 0;                      // mean over all discs and frames
  std::int64_t count_ = 0;
};

/// Packs frames. Each is a sequence of columns of 16-bit numbers, low bytes first (append_planes); numbers of
/// more bits are several columns, the lowest first:
/// - ids, as differences from the previous in the list, of 64 bits, if they differ from those of the previous
///   frame (`new_ids`);
/// - codes of each disc column; with old ids, their differences d from those of the previous frame, modulo
///   2^16, as 2 d, or -2 d - 1 if d < 0;
/// - of contacts the first disc, as the difference from the previous in the list, and the second disc minus
///   the first, modulo 2^32;
/// - codes of each contact column.
/// Columns without any number are left out.
class ScenePacker {
 public:
  explicit ScenePacker(const SceneRanges& ranges);

  void add(const Frame& frame);
  /// What is needed to unpack them, one object per frame.
  const Json& frames() const { return frames_; }
  /// base64
  std::string finish() { return base64(packed_.finish()); }

 private:
  void add_discs(const SceneFrame& scene, bool new_ids, std::string& bytes);
  void add_contacts(const SceneFrame& scene, std::string& bytes) const;

  SceneOptions options_;
  std::vector<std::optional<Quantiser>> discs_, contacts_;
  std::vector<std::int64_t> ids_;                 // of the previous frame
  std::vector<std::vector<std::uint16_t>> last_;  // codes of its discs
  Json frames_ = Json::array();
  Deflated packed_;
};

}  // namespace mikromakro
