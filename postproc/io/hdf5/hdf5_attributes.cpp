// SPDX-License-Identifier: GPL-2.0-or-later
// Attributes: strings and numbers.
#include <fmt/format.h>

#include <algorithm>

#include "io/hdf5/hdf5_calls.h"
#include "io/hdf5/hdf5_turn.h"
#include "model/error.h"

namespace mikromakro {
namespace {

Hdf5Id text_type(std::size_t length, H5T_cset_t letters) {
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length);
  H5Tset_cset(type.get(), letters);
  H5Tset_strpad(type.get(), length == H5T_VARIABLE ? H5T_STR_NULLTERM : H5T_STR_NULLPAD);
  return type;
}

// Fixed-length strings, as other programs write them.
std::vector<std::string> fixed_texts(const Hdf5Id& attribute, const Hdf5Id& type, std::size_t count,
                                     const std::string& place) {
  const std::size_t length = H5Tget_size(type.get());
  std::string letters(count * length, '\0');
  if (H5Aget_storage_size(attribute.get()) != letters.size() ||
      H5Aread(attribute.get(), type.get(), letters.data()) < 0)
    cannot_read(place);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < count; ++i) {
    std::string text = letters.substr(i * length, length);
    text.resize(std::min(text.find('\0'), text.size()));
    text.resize(text.find_last_not_of(' ') + 1);
    texts.push_back(std::move(text));
  }
  return texts;
}

// See Hdf5File::guarded_attribute.
const std::string guarded = "_guarded";

Hdf5Id marked_text() {
  Hdf5Id type = text_type(H5T_VARIABLE, H5T_CSET_UTF8);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  return type;
}

bool is_marked(const Hdf5Id& attribute) {
  const Hdf5Id type(H5Aget_type(attribute.get()), H5Tclose);
  return H5Tget_class(type.get()) == H5T_STRING && H5Tis_variable_str(type.get()) > 0 &&
         H5Tget_strpad(type.get()) == H5T_STR_NULLPAD;
}

std::vector<std::string> texts_of(const Hdf5Id& attribute, const std::string& place) {
  const Hdf5Id space(H5Aget_space(attribute.get()), H5Sclose);
  const auto count = H5Sget_simple_extent_npoints(space.get());
  if (count < 0) cannot_read(place);
  const Hdf5Id stored(H5Aget_type(attribute.get()), H5Tclose);
  if (H5Tget_class(stored.get()) == H5T_STRING && H5Tis_variable_str(stored.get()) == 0)
    return fixed_texts(attribute, stored, static_cast<std::size_t>(count), place);
  std::vector<char*> texts(static_cast<std::size_t>(count), nullptr);
  const Hdf5Id type = text_type(H5T_VARIABLE, H5T_CSET_UTF8);
  if (H5Aread(attribute.get(), type.get(), texts.data()) < 0) cannot_read(place);
  std::vector<std::string> values;
  values.reserve(texts.size());
  for (const char* text : texts) values.emplace_back(text != nullptr ? text : "");
  H5Dvlen_reclaim(type.get(), space.get(), H5P_DEFAULT, texts.data());
  return values;
}

}  // namespace

std::string last_reason() {
  std::string reason = "an error";
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* error, void* text) {
        if (error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
        return herr_t{1};
      },
      &reason);
  return in_quotes(reason);
}

void cannot_read(const std::string& place) {
  throw bad_input({place}, "cannot read from the file",
                  "a complete HDF5 file of mikromakro (text dumps: --particles)", last_reason());
}

void cannot_write(const std::string& place) {
  throw run_failed(fmt::format("{}: cannot write the output", place), "space on the disk", last_reason());
}

std::optional<std::vector<std::string>> Hdf5Dataset::text_attribute(const std::string& name) const {
  const Hdf5Turn turn;
  if (H5Aexists(id_.get(), name.c_str()) <= 0) return {};
  const Hdf5Id id(H5Aopen(id_.get(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (is_marked(id) && H5Aexists(id_.get(), (name + guarded).c_str()) > 0)
    return text_attribute(name + guarded);
  return texts_of(id, fmt::format("{}@{}", place_, name));
}

void Hdf5File::add_attribute(const std::string& path, const std::string& name, const Hdf5Id& space,
                             std::int64_t type, const void* value) {
  const Hdf5Turn turn;
  const Hdf5Id id(H5Acreate_by_name(id_.get(), path.c_str(), name.c_str(), type, space.get(), H5P_DEFAULT,
                                    H5P_DEFAULT, H5P_DEFAULT),
                  H5Aclose);
  if (id.get() < 0 || (value != nullptr && H5Awrite(id.get(), type, value) < 0)) cannot_write(file_);
}

void Hdf5File::attribute(const std::string& path, const std::string& name, const std::string& value) {
  const Hdf5Turn turn;
  const char* const text = value.c_str();
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose);
  add_attribute(path, name, space, text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(), &text);
}

void Hdf5File::guarded_attribute(const std::string& path, const std::string& name, const std::string& value) {
  const Hdf5Turn turn;
  const char* const text = value.c_str();
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose);
  add_attribute(path, name, space, marked_text().get(), &text);
  short_attribute(path, name + guarded, value);
}

void Hdf5File::attribute(const std::string& path, const std::string& name,
                         const std::vector<std::string>& values) {
  const Hdf5Turn turn;
  std::vector<const char*> texts;
  texts.reserve(values.size());
  for (const std::string& value : values) texts.push_back(value.c_str());
  add_attribute(path, name, space_of({values.size()}), text_type(H5T_VARIABLE, H5T_CSET_UTF8).get(),
                texts.data());
}

void Hdf5File::attribute(const std::string& path, const std::string& name,
                         std::span<const std::int64_t> numbers) {
  const Hdf5Turn turn;
  add_attribute(path, name, space_of({numbers.size()}), H5T_NATIVE_INT64, numbers.data());
}

void Hdf5File::attribute(const std::string& path, const std::string& name, std::int64_t number) {
  const Hdf5Turn turn;
  add_attribute(path, name, Hdf5Id(H5Screate(H5S_SCALAR), H5Sclose), H5T_NATIVE_INT64, &number);
}

bool Hdf5File::has_attribute(const std::string& path, const std::string& name) const {
  const Hdf5Turn turn;
  return H5Aexists_by_name(id_.get(), path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::short_attribute(const std::string& path, const std::string& name, const std::string& value) {
  const Hdf5Turn turn;
  const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose);
  add_attribute(path, name, space, text_type(value.size(), H5T_CSET_ASCII).get(), value.data());
}

std::vector<std::int64_t> Hdf5File::number_attribute(const std::string& path, const std::string& name) const {
  const Hdf5Turn turn;
  const Hdf5Id id(H5Aopen_by_name(id_.get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  const Hdf5Id space(H5Aget_space(id.get()), H5Sclose);
  const auto count = H5Sget_simple_extent_npoints(space.get());
  const Hdf5Id type(H5Aget_type(id.get()), H5Tclose);
  if (id.get() >= 0 && H5Tget_class(type.get()) != H5T_INTEGER)
    throw bad_input({fmt::format("{}:{}@{}", file_, path, name)}, "not a whole number", "whole numbers",
                    "numbers of another kind");
  std::vector<std::int64_t> numbers(count > 0 ? static_cast<std::size_t>(count) : 0);
  if (count < 0 || H5Aread(id.get(), H5T_NATIVE_INT64, numbers.data()) < 0)
    cannot_read(fmt::format("{}:{}@{}", file_, path, name));
  return numbers;
}

std::vector<std::string> Hdf5File::text_attribute(const std::string& path, const std::string& name) const {
  const Hdf5Turn turn;
  const Hdf5Id id(H5Aopen_by_name(id_.get(), path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (is_marked(id) && has_attribute(path, name + guarded)) return text_attribute(path, name + guarded);
  return texts_of(id, fmt::format("{}:{}@{}", file_, path, name));
}

}  // namespace mikromakro
