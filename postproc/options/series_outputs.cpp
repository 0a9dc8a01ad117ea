// SPDX-License-Identifier: GPL-2.0-or-later
#include "options/series_outputs.h"

#include <iostream>
#include <utility>

#include "averaging/volumes/volume_outlines.h"
#include "io/tables/series_csv.h"
#include "io/tables/series_hdf5.h"
#include "io/tables/series_vtkhdf.h"

namespace mikromakro {
namespace {

std::unique_ptr<SeriesWriter> writer_of(const std::string& name, OutputFile& file,
                                        const SeriesColumns& columns, const Eigen::Vector2d& center) {
  if (name.ends_with(".csv"))
    return std::make_unique<SeriesCsv>(columns,
                                       [&file](const SeriesCsv::Write& write) { file.commit(write); });
  if (name.ends_with(".h5")) return std::make_unique<SeriesHdf5>(file.temporary(), columns);
  return std::make_unique<SeriesVtkhdf>(file.temporary(), columns,
                                        volume_outlines({columns.of_volume, columns.volumes}, center));
}

}  // namespace

SeriesOutputs::SeriesOutputs(OutputFiles files, const SeriesColumns& columns, const Eigen::Vector2d& center)
    : files_(std::move(files)) {
  for (const auto& [name, file] : files_.files) writers_.push_back(writer_of(name, *file, columns, center));
  if (files_.to_stdout)
    writers_.push_back(std::make_unique<SeriesCsv>(columns, [](const SeriesCsv::Write& write) {
      write(std::cout);
      std::cout.flush();
    }));
}

void SeriesOutputs::add(const Eigen::ArrayXd& window, const Rows& values) {
  for (const auto& writer : writers_) writer->add(window, values);
}

void SeriesOutputs::commit(const Preamble& preamble) {
  for (std::size_t i = 0; i < writers_.size(); ++i) {
    writers_[i]->finish(preamble);
    const bool is_text = i >= files_.files.size() || files_.files[i].name.ends_with(".csv");
    if (!is_text) files_.files[i].file->publish();
  }
}

}  // namespace mikromakro
