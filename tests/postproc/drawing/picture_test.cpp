// SPDX-License-Identifier: GPL-2.0-or-later
// Two discs and a wall disc, pressed and pulled: what is where in the picture.
#include "drawing/picture.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <numbers>
#include <regex>

namespace mikromakro {
namespace {

// Discs of radius 1 at (0, 0), (2, 0) and a wall disc at (4, 0): the window is -1..5 x -1..1. Force 3 N
// between 1 and 2 (pressed), -1 N between 2 and 3 (pulled).
Frame three_discs() {
  Frame frame;
  frame.step = 7;
  for (int i = 0; i < 3; ++i)
    frame.particles.push_back({i + 1, i < 2 ? 1 : 2, {2.0 * i, 0}, 1, {0.5 * i, 0}, 0, 1});
  frame.contacts = {{1, 2, 0, 1, {1, 0}, 0, {-3, 0}, 0}, {2, 3, 1, 2, {1, 0}, 0, {1, 0}, 0}};
  return frame;
}

std::string picture(const PictureStyle& style, Canvas::Kind kind) {
  const Frame frame = three_discs();
  PictureScales scales;
  scales.add(frame, style);
  return draw_picture(frame, style, scales, kind);
}

// Styles as cairo writes them up to 1.16, `stroke:rgb(5%,5%,5%);`, from attributes of later versions,
// `stroke="rgb(5%, 5%, 5%)"`.
std::string picture_text(const Frame& frame, const PictureStyle& style, const PictureScales& scales) {
  const std::string svg = draw_picture(frame, style, scales, Canvas::Kind::svg);
  const std::string together = std::regex_replace(svg, std::regex("%, "), "%,");
  return std::regex_replace(together, std::regex(" (stroke[a-z-]*)=\"([^\"]*)\""), "$1:$2;");
}

std::string picture_text(const PictureStyle& style) {
  const Frame frame = three_discs();
  PictureScales scales;
  scales.add(frame, style);
  return picture_text(frame, style, scales);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// p = sum f_n/(2 pi a h): of disc 1 3/(2 pi 0.5), of disc 2 (3 - 1)/(2 pi 0.5)
TEST(DiscValues, PressureAndContactsAsWorkedByHand) {
  const auto pressure = disc_values(three_discs(), DiscQuantity::pressure, 0.5);
  EXPECT_NEAR(pressure[0], 3 / std::numbers::pi, 1e-15);
  EXPECT_NEAR(pressure[1], 2 / std::numbers::pi, 1e-15);
  EXPECT_EQ(disc_values(three_discs(), DiscQuantity::contacts, 1), (std::vector<double>{1, 2, 1}));
}

TEST(PictureScales, HoldAllFramesAndBulkDiscsOnly) {
  PictureStyle style;
  style.bulk_types = {1};
  style.quantity = &disc_quantity("velocity");
  PictureScales scales;
  Frame frame = three_discs();
  scales.add(frame, style);
  frame.particles[0].position.y() = 9;
  frame.particles[0].velocity.y() = 4;
  scales.add(frame, style);
  EXPECT_EQ(scales.window->low, Eigen::Vector2d(-1, -1));
  EXPECT_EQ(scales.window->high, Eigen::Vector2d(5, 10));
  EXPECT_EQ(scales.values.low, 0);
  EXPECT_EQ(scales.values.high, 4);
  EXPECT_EQ(scales.mean_force, 2);
}

// The outline of discs, the lines of the network and of the chains each have a colour of their own.
TEST(PictureSvg, HasEveryDiscAndEveryContactOnce) {
  PictureStyle style;
  style.network = true;
  style.chains = true;
  const std::string svg = picture_text(style);
  EXPECT_EQ(count(svg, "stroke:rgb(0%,0%,0%);stroke-opacity:0.4;"), 3U);
  EXPECT_EQ(count(svg, "stroke:rgb(15%,15%,15%)"), 2U);
  EXPECT_EQ(count(svg, "stroke:rgb(5%,5%,5%)"), 2U);  // the contact and the key
  EXPECT_EQ(count(svg, "stroke:rgb(84%,10%,11%)"), 2U);
  EXPECT_TRUE(svg == picture_text(style));
}

// A box of 6 m, periodic along x, of -0.5 to 5.5: disc 1 (-1 to 1) is cut at the left edge and goes on at the
// right one, as disc 3 does, and so does the line between the two of them: 4 discs and lines on either side
// of the boundary.
TEST(PictureSvg, DiscsAndContactsGoOnBeyondAPeriodicBoundary) {
  PictureStyle style;
  style.network = true;
  Frame frame = three_discs();
  frame.box = {{-0.5, -9}, {5.5, 9}, {true, false}};
  frame.contacts.push_back({3, 1, 2, 0, {1, 0}, 0, {-1, 0}, 0});
  PictureScales scales;
  scales.add(frame, style);
  EXPECT_EQ(scales.window->low, Eigen::Vector2d(-0.5, -1));
  EXPECT_EQ(scales.window->high, Eigen::Vector2d(5.5, 1));
  const std::string svg = picture_text(frame, style, scales);
  EXPECT_EQ(count(svg, "stroke:rgb(0%,0%,0%);stroke-opacity:0.4;"), 4U);
  EXPECT_EQ(count(svg, "stroke:rgb(15%,15%,15%)"), 4U);
  // A disc that lies a period beside the window is in it all the same.
  frame.particles[1].position.x() += 6;
  frame.contacts.clear();
  EXPECT_EQ(count(picture_text(frame, style, scales), "stroke:rgb(0%,0%,0%);stroke-opacity:0.4;"), 4U);
}

// Chains are as wide as their forces: 3 N and 1 N with a mean of 2 N, radius r pixels: 0.2 r 3/2 and 0.2 r/2.
TEST(PictureSvg, ChainsAreAsWideAsTheirForces) {
  PictureStyle style;
  style.chains = true;
  style.width = 62 * 8;
  const std::string svg = picture_text(style);
  const double radius = (style.width - 2.0 * 8) / 6;
  const auto width = [&](const std::string& colour) {
    const std::size_t at = svg.rfind("stroke-width:", svg.find(colour));
    return std::strtod(svg.c_str() + at + std::strlen("stroke-width:"), nullptr);
  };
  EXPECT_NEAR(width("stroke:rgb(5%,5%,5%)"), 0.3 * radius, 1e-5);  // digits of the file
  EXPECT_NEAR(width("stroke:rgb(84%,10%,11%)"), 0.1 * radius, 1e-5);
}

struct Image {
  explicit Image(const std::string& png) : content(png) {
    surface.reset(cairo_image_surface_create_from_png_stream(
        [](void* self, unsigned char* data, unsigned length) {
          auto& image = *static_cast<Image*>(self);
          std::memcpy(data, image.content.data() + image.read, length);
          image.read += length;
          return CAIRO_STATUS_SUCCESS;
        },
        this));
  }
  int width() const { return cairo_image_surface_get_width(surface.get()); }
  int height() const { return cairo_image_surface_get_height(surface.get()); }
  unsigned at(int x, int y) const {
    const unsigned char* row =
        cairo_image_surface_get_data(surface.get()) + y * cairo_image_surface_get_stride(surface.get());
    unsigned pixel = 0;
    std::memcpy(&pixel, row + std::ptrdiff_t{4} * x, sizeof pixel);
    return pixel & 0xffffffU;
  }

  std::string content;
  std::size_t read = 0;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface{nullptr, &cairo_surface_destroy};
};

// Bytes to half a step of rounding, which Cairo does in 16 bits first.
void expect_colour(unsigned pixel, const Colour& colour) {
  const double parts[] = {colour.red, colour.green, colour.blue};
  for (unsigned i = 0; i < 3; ++i) EXPECT_NEAR((pixel >> (16 - 8 * i)) & 0xffU, parts[i] * 255, 1);
}

// letter = 10, margin = 10, bar 75: 6 m in 525 pixels, 87.5 per m; disc 1 has its centre at (10 + 87.5, 10
// + 87.5).
TEST(PicturePng, HasItsSizeAndColoursWhereTheDiscsAre) {
  PictureStyle style;
  style.width = 620;
  style.bulk_types = {1};
  style.quantity = &disc_quantity("radius");
  const Image image(picture(style, Canvas::Kind::png));
  EXPECT_EQ(image.width(), 620);
  EXPECT_EQ(image.height(), 10 + 175 + 30);
  expect_colour(image.at(97, 97), viridis(0.5));  // one radius only: the middle of the map
  expect_colour(image.at(272, 97), viridis(0.5));
  expect_colour(image.at(447, 97), {0.62, 0.62, 0.62, 1});
  EXPECT_EQ(image.at(97 + 87, 15), 0xffffffU);  // above the gap between the discs
}

}  // namespace
}  // namespace mikromakro
