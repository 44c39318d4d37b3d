#include "links/link_set.h"

#include <gtest/gtest.h>

#include <random>

namespace viewcover {
namespace {

std::vector<OccluderId> random_list(std::mt19937_64& random) {
  std::vector<OccluderId> list;
  std::size_t id = random() % 4;
  for (std::size_t n = random() % 20; n > 0; --n) {
    list.emplace_back(id);
    id += 1 + (random() % 3 == 0 ? random() % 3000000 : random() % 130);
  }
  return list;
}

TEST(LinkSet, GivesBackWhatWasAddedInPiecesAndInOrder) {
  std::mt19937_64 random(1);
  LinkSet all;
  std::vector<Link> links;
  std::vector<std::vector<OccluderId>> lists;
  for (int piece = 0; piece < 20; ++piece) {
    LinkSet part;
    for (int i = 0; i < piece * 3; ++i) {
      links.push_back({RegionAddress(PartId(random() % 7), 3, random() % 64),
                       ElementAddress(SurfaceId(random() % 1000)).child(2),
                       static_cast<Verdict>(random() % 3)});
      lists.push_back(random_list(random));
      part.add(links.back(), lists.back());
    }
    part.count(Verdict::kHiddenByOne);
    all.append(std::move(part));
    EXPECT_EQ(part.size(), 0u);
  }
  ASSERT_EQ(all.size(), links.size());
  std::array<std::uint64_t, 3> counted{};
  for (std::size_t i = 0; i < links.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(all[i].region, links[i].region);
    EXPECT_EQ(all[i].element, links[i].element);
    EXPECT_EQ(all[i].verdict, links[i].verdict);
    EXPECT_EQ(all.occluders(i), lists[i]);
    ++counted[static_cast<std::size_t>(links[i].verdict)];
  }
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(all.verdicts(static_cast<Verdict>(v)), counted[v]);
  }
  EXPECT_EQ(all.verdicts(Verdict::kHiddenByOne), 20u);
}

TEST(LinkSet, PacksNearOccludersIntoAByteEach) {
  LinkSet links;
  std::vector<OccluderId> list;
  for (std::size_t id = 0; id < 40; ++id) list.emplace_back(id * 3);
  for (int i = 0; i < 1 << 12; ++i) links.add({}, list);
  EXPECT_LE(links.memory_bytes() / links.size(), 2u * (32 + 40));
}

TEST(LinkSet, GoesThroughBytesInPiecesAndRefusesOthers) {
  std::mt19937_64 random(2);
  LinkSet all, read;
  std::string bytes;
  for (int piece = 0; piece < 5; ++piece) {
    const std::size_t before = all.size();
    for (int i = 0; i < 40; ++i) {
      all.add({RegionAddress(PartId(random() % 7), 3, random() % 64),
               ElementAddress(SurfaceId(random() % 1000), 14, random() % (1 << 28)),
               static_cast<Verdict>(random() % 3)},
              random_list(random));
    }
    bytes = all.to_bytes(before);
    EXPECT_TRUE(read.add_bytes(bytes));
  }
  ASSERT_EQ(read.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(read[i].region, all[i].region);
    EXPECT_EQ(read[i].element, all[i].element);
    EXPECT_EQ(read[i].verdict, all[i].verdict);
    EXPECT_EQ(read.occluders(i), all.occluders(i));
  }
  for (std::size_t v = 0; v < 3; ++v) {
    EXPECT_EQ(read.verdicts(static_cast<Verdict>(v)), all.verdicts(static_cast<Verdict>(v)));
  }
  LinkSet other;
  EXPECT_FALSE(other.add_bytes(std::string_view(bytes).substr(0, bytes.size() - 1)));
  EXPECT_FALSE(other.add_bytes(std::string(4, '\xff')));
  EXPECT_FALSE(other.add_bytes(std::string(11, '\x80') + '\1'));
  // Part 0, a level that is too deep, a verdict that is no link.
  EXPECT_FALSE(other.add_bytes(std::string_view("\0\0\0\1\0\0\0\0", 8)));
  EXPECT_FALSE(other.add_bytes(std::string_view("\1\20\0\1\0\0\0\0", 8)));
  EXPECT_FALSE(other.add_bytes(std::string_view("\1\0\0\1\0\0\5\0", 8)));
  EXPECT_EQ(other.size(), 39u);
  EXPECT_TRUE(other.add_bytes(std::string_view("\1\0\0\1\0\0\0\0", 8)));
}

}  // namespace
}  // namespace viewcover
