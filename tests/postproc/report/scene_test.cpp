// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/scene.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <numbers>

#include "report/page.h"

namespace mikromakro {
namespace {

TEST(Quantiser, IsOffByHalfAStepAtMost) {
  const Quantiser quantiser({-0.25, 0.75}, 12);
  EXPECT_DOUBLE_EQ(quantiser.step(), 1.0 / 4094);
  // half a step, and the rounding of numbers below 1
  for (double x = -0.25; x <= 0.75; x += 0.00137)
    EXPECT_NEAR(quantiser.value(quantiser.code(x)), x, quantiser.step() / 2 + 1e-15);
  EXPECT_DOUBLE_EQ(quantiser.value(quantiser.code(0.75)), 0.75);
}

TEST(Quantiser, KeepsWholeNumbersAndWhatIsNotKnown) {
  const Quantiser types({1, 4}, 16, true);
  for (const double type : {1.0, 2.0, 3.0, 4.0}) EXPECT_EQ(types.value(types.code(type)), type);
  EXPECT_TRUE(std::isnan(types.value(types.code(not_given))));
  EXPECT_EQ(Quantiser({7, 7}, 16).value(0), 7);  // one number only
}

// RFC 4648, section 10
TEST(Base64, OfTheExamplesOfItsStandard) {
  const char* const examples[][2] = {{"", ""},
                                     {"f", "Zg=="},
                                     {"fo", "Zm8="},
                                     {"foo", "Zm9v"},
                                     {"foob", "Zm9vYg=="},
                                     {"fooba", "Zm9vYmE="},
                                     {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : examples) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64("\xFF\xFE\xFB"), "//77");
}

TEST(Deflated, InflatesToTheSameBytes) {
  Deflated packed;
  std::string all;
  for (int i = 0; i < 50; ++i) {
    std::string part;
    for (int k = 0; k < 5000; ++k) part += static_cast<char>((i * k * k) % 251);
    packed.add(part);
    all += part;
  }
  const std::string bytes = packed.finish();
  std::string back(all.size(), '\0');
  uLongf size = back.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(back.data()), &size,
                       reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()),
            Z_OK);
  EXPECT_TRUE(back == all);
}

TEST(Planes, LowBytesComeFirst) {
  std::string bytes;
  append_planes(std::vector<std::uint16_t>{0x0102, 0x0304}, bytes);
  EXPECT_EQ(bytes, "\x02\x04\x01\x03");
}

// Disc 9 left of disc 2; 5 N push them apart, and 2 N pull disc 9 downwards: with n = (1, 0), t = (0, 1).
Frame two_discs() {
  Frame frame;
  frame.particles.resize(2);
  frame.particles[0].id = 9;
  frame.particles[0].position = {0, 0};
  frame.particles[1].id = 2;
  frame.particles[1].position = {0.9, 0};
  for (Particle& disc : frame.particles) disc.radius = 0.5;
  Contact contact;
  contact.id1 = 9;
  contact.id2 = 2;
  contact.index1 = 0;
  contact.index2 = 1;
  contact.normal = {1, 0};
  contact.overlap = 0.1;
  contact.force = {-5, -2};
  Contact wall = contact;
  wall.id2 = -3;
  wall.index2 = -1;
  wall.normal = {0, -1};
  wall.force = {0, 7};
  frame.contacts = {wall, contact};
  return frame;
}

TEST(SceneFrame, DiscsByIdAndContactsByDiscs) {
  const SceneFrame scene = scene_frame(two_discs(), 2);
  EXPECT_EQ(scene.ids, (std::vector<std::int64_t>{2, 9}));
  EXPECT_EQ(scene.first, (std::vector<std::uint32_t>{1, 1}));
  EXPECT_EQ(scene.second, (std::vector<std::uint32_t>{0, 0xFFFFFFFC}));  // 2^32 - 1 - 3
  const auto expect = [&](std::size_t column, double of_disc, double of_wall) {
    EXPECT_DOUBLE_EQ(scene.contacts[column][0], of_disc) << column;
    EXPECT_DOUBLE_EQ(scene.contacts[column][1], of_wall) << column;
  };
  expect(0, 0, 1.5 * std::numbers::pi);
  expect(1, 0.1, 0.1);
  expect(2, 5, 7);
  expect(3, -2, 0);
  // (5 + 7) N over 2 pi a h, and 5 N
  EXPECT_DOUBLE_EQ(scene.discs[7][1], 12 / (2 * std::numbers::pi * 0.5 * 2));
  EXPECT_DOUBLE_EQ(scene.discs[7][0], 5 / (2 * std::numbers::pi * 0.5 * 2));
}

TEST(SceneFrame, AlongPeriodicAxesDiscsAreInTheBox) {
  Frame frame = two_discs();
  frame.box = {{0, 0}, {4, 4}, {true, false}};
  frame.particles[0].position = {-0.5, -0.5};
  const SceneFrame scene = scene_frame(frame, 1);
  EXPECT_DOUBLE_EQ(scene.discs[0][1], 3.5);
  EXPECT_DOUBLE_EQ(scene.discs[1][1], -0.5);
}

TEST(Scene, HasNoColumnsThatTheInputHasNot) {
  Frame frame = two_discs();
  frame.contacts.clear();
  frame.contacts_known = false;
  SceneRanges ranges{SceneOptions{}};
  ranges.add(frame);
  const Json description = ranges.description();
  std::vector<std::string> names;
  for (const Json& column : description["disc_columns"]) names.push_back(column["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"x", "y", "radius", "type"}));
  EXPECT_TRUE(description["contact_columns"].empty());
  for (const Json& quantity : description["quantities"])
    EXPECT_TRUE(quantity["name"] == "radius" || quantity["name"] == "type") << quantity["name"];
}

// Whatever stands in the data: it cannot end its element, and reads as it was.
TEST(Page, DataAreHarmlessAndComplete) {
  const std::string hostile = "</script><script>alert(1)</script><!-- \xE2\x80\xA8 \" ' & \\";
  const std::string page = page_html({{"title", hostile}}, "QUJD");
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  const std::string begin = "id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  const std::size_t to = page.find("</script>", from);
  EXPECT_EQ(Json::parse(page.substr(from, to - from))["title"], hostile);
  EXPECT_NE(page.find(">QUJD</script>"), std::string::npos);
}

// The only addresses in the page are names of formats.
TEST(Page, AsksForNothingFromElsewhere) {
  const std::string page = page_html(Json::object(), "");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (std::size_t at = page.find("://"); at != std::string::npos; at = page.find("://", at + 1))
    EXPECT_EQ(page.substr(at - 4, 27), "http://www.w3.org/2000/svg\"") << page.substr(at - 40, 80);
  for (const char* const word : {" src=", "href=", "@import", "url("})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace mikromakro
