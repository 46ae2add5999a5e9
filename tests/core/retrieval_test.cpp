// Key poses found again in a library of features, whole body and per part.
#include "core/editing/retrieval.h"

#include <bit>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace kumite {
namespace {

/// Features that change as often as those of real motion: a run of `run` frames on average.
std::vector<PoseBits> noise(int frames, std::uint32_t seed, int run = 6) {
    std::mt19937 random(seed);
    std::vector<PoseBits> bits;
    PoseBits now = random() & kAllPoseBits;
    for (int f = 0; f < frames; ++f) {
        if (random() % static_cast<unsigned>(run) == 0)
            now ^= PoseBits(1) << (random() % kPoseBitCount);
        bits.push_back(now);
    }
    return bits;
}

KeySequence keysOf(std::span<const PoseBits> bits, std::vector<int> frames) {
    KeySequence keys;
    keys.frames = frames;
    for (const int f : frames)
        keys.bits.push_back(bits[static_cast<std::size_t>(f)]);
    return keys;
}

/// The least number of differing features, by trying every choice of frames.
int byTrying(std::span<const PoseBits> bits, const KeySequence& keys, PoseBits mask, double fastest,
             double slowest, std::size_t k, int frame) {
    const int here = std::popcount((bits[static_cast<std::size_t>(frame)] ^ keys.bits[k]) & mask);
    if (k == 0) return here;
    const int wanted = keys.frames[k] - keys.frames[k - 1];
    const int least = std::max(1, static_cast<int>(wanted * fastest));
    const int most = std::max(least, static_cast<int>(std::ceil(wanted * slowest)));
    int best = 10000;
    for (int gap = least; gap <= most && gap <= frame; ++gap)
        best = std::min(best, byTrying(bits, keys, mask, fastest, slowest, k - 1, frame - gap));
    return here + best;
}

TEST(Retrieval, FindsWhatTryingEverythingFinds) {
    for (std::uint32_t seed = 1; seed <= 30; ++seed) {
        FeatureLibrary library;
        library.add("a", noise(40, seed, 2));
        library.add("b", noise(25, 100 + seed, 2));
        const KeySequence keys = keysOf(noise(30, 200 + seed, 2), {2, 5, 6, 14});
        RetrievalSettings settings;
        settings.mask = seed % 3 == 0 ? maskOf(BodyPart::LeftArm) : kAllPoseBits;
        const auto found = findSimilar(library, keys, settings);
        int best = 10000;
        for (const auto& clip : library.clips) {
            const auto bits =
                std::span(library.bits).subspan(std::size_t(clip.begin), std::size_t(clip.frames));
            for (int last = 0; last < clip.frames; ++last)
                best = std::min(best, byTrying(bits, keys, settings.mask, 0.5, 2.0, 3, last));
        }
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found.front().mismatches, best) << seed;
        // What is reported is what stands in the library.
        for (const KeyMatch& match : found) {
            int differing = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const int at = library.clips[std::size_t(match.clip)].begin + match.frames[k];
                differing +=
                    std::popcount((library.bits[std::size_t(at)] ^ keys.bits[k]) & settings.mask);
                if (k > 0) {
                    EXPECT_GT(match.frames[k], match.frames[k - 1]);
                }
            }
            EXPECT_EQ(differing, match.mismatches);
        }
        for (std::size_t i = 1; i < found.size(); ++i)
            EXPECT_LE(found[i - 1].mismatches, found[i].mismatches) << "a relevance list";
    }
}

TEST(Retrieval, FindsAPlantedClipInNoise) {
    const auto planted = noise(90, 7);
    FeatureLibrary library;
    for (std::uint32_t clip = 0; clip < 40; ++clip) {
        auto bits = noise(500, 50 + clip);
        if (clip == 23) std::copy(planted.begin(), planted.end(), bits.begin() + 211);
        library.add("clip " + std::to_string(clip), bits);
    }
    const KeySequence keys = keysOf(planted, {3, 20, 37, 61, 88});
    const auto found = findSimilar(library, keys);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().clip, 23);
    EXPECT_EQ(found.front().mismatches, 0);
    EXPECT_EQ(found.front().stretch, 0) << "of equally good places the one in time";
    // A frame beside it may show the same features.
    for (std::size_t k = 0; k < 5; ++k)
        EXPECT_NEAR(found.front().frames[k], 211 + keys.frames[k], 1);
    ASSERT_GT(found.size(), 1u);
    EXPECT_GT(found[1].mismatches, 0);
}

TEST(Retrieval, FindsAPartInAnotherClipThanTheWhole) {
    const auto whole = noise(80, 7), arm = noise(80, 8, 3);
    const PoseBits mask = maskOf(BodyPart::RightArm);
    FeatureLibrary library;
    for (std::uint32_t clip = 0; clip < 30; ++clip) {
        auto bits = noise(300, 90 + clip);
        for (std::size_t f = 0; f < 80; ++f) {
            if (clip == 4) bits[f + 100] = (whole[f] & ~mask) | (bits[f + 100] & mask);
            if (clip == 17) bits[f + 60] = (arm[f] & mask) | (bits[f + 60] & ~mask);
        }
        library.add("clip " + std::to_string(clip), bits);
    }
    std::vector<PoseBits> query(80);
    for (std::size_t f = 0; f < 80; ++f)
        query[f] = (whole[f] & ~mask) | (arm[f] & mask);
    std::vector<int> frames;
    for (int f = 0; f < 80; f += 7)
        frames.push_back(f);
    const KeySequence keys = keysOf(query, frames);
    EXPECT_EQ(findSimilar(library, keys).front().clip, 4);
    RetrievalSettings settings;
    settings.mask = mask;
    const auto found = findSimilar(library, keys, settings);
    EXPECT_EQ(found.front().clip, 17);
    EXPECT_EQ(found.front().mismatches, 0);
    EXPECT_NEAR(found.front().frames.front(), 60, 1);
    settings.within = {{4, {0, 300}}};
    for (const KeyMatch& match : findSimilar(library, keys, settings))
        EXPECT_EQ(match.clip, 4);
    settings.within = {{17, {61, 300}}, {3, {0, 20}}};
    const auto inside = findSimilar(library, keys, settings);
    ASSERT_FALSE(inside.empty());
    for (const KeyMatch& match : inside) {
        EXPECT_EQ(match.clip, 17) << "the other stretch is too short";
        EXPECT_GE(match.frames.front(), 61);
        EXPECT_LT(match.frames.back(), 300);
    }
}

TEST(Retrieval, FollowsAnotherSpeedWithinItsLimits) {
    const auto slow = noise(100, 5, 9);
    std::vector<PoseBits> fast;
    for (std::size_t f = 0; f < slow.size(); f += 2)
        fast.push_back(slow[f]);
    FeatureLibrary library;
    library.add("fast", fast);
    const KeySequence keys = keysOf(slow, {0, 24, 48, 72, 96});
    const auto found = findSimilar(library, keys);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().mismatches, 0);
    EXPECT_EQ(found.front().frames, (std::vector<int>{0, 12, 24, 36, 48}));
    EXPECT_NEAR(found.front().stretch, std::log(2.0), 1e-9);
    RetrievalSettings strict;
    strict.fastest = 0.9;
    EXPECT_TRUE(findSimilar(library, keys, strict).empty())
        << "the clip is too short at that speed";
}

TEST(Retrieval, TakesPiecesOfLongClipsTogether) {
    // A match that lies across the border of two pieces of a long clip.
    auto bits = noise(20000, 3);
    const auto planted = noise(60, 4);
    std::copy(planted.begin(), planted.end(), bits.begin() + 8192 - 30);
    FeatureLibrary library;
    library.add("long", bits);
    const auto found = findSimilar(library, keysOf(planted, {0, 15, 30, 45, 59}));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().mismatches, 0);
    EXPECT_EQ(found.front().frames.front(), 8192 - 30);
}

TEST(Retrieval, OneKeyAloneAndNoneAtAll) {
    FeatureLibrary library;
    library.add("a", std::vector<PoseBits>{1, 2, 4, 8, 8, 8, 16});
    const auto found = findSimilar(library, {{8}, {5}});
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().mismatches, 0);
    EXPECT_EQ(found.front().frames.size(), 1u);
    EXPECT_EQ(found.front().stretch, 0);
    EXPECT_THROW(findSimilar(library, {}), Error);
    EXPECT_THROW(findSimilar(library, {{1, 2}, {4, 4}}), Error) << "two keys in one frame";
    EXPECT_THROW(findSimilar(library, {{1, 2}, {4, 3}}), Error) << "out of order";
    EXPECT_TRUE(findSimilar({}, {{8}, {5}}).empty());
}

TEST(Retrieval, ManyKeysCostNoOverflow) {
    FeatureLibrary library;
    library.add("a", std::vector<PoseBits>(400, 0));
    KeySequence keys;
    for (int k = 0; k < 60; ++k) {
        keys.bits.push_back(kAllPoseBits);
        keys.frames.push_back(5 * k);
    }
    const auto found = findSimilar(library, keys);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().mismatches, 60 * kPoseBitCount);
    // Keys far from each other lie beyond any library; more than a thousand are refused.
    EXPECT_TRUE(findSimilar(library, {{1, 2, 4}, {0, 1'000'000'000, 2'000'000'000}}).empty());
    while (keys.bits.size() <= 1000) {
        keys.bits.push_back(0);
        keys.frames.push_back(keys.frames.back() + 1);
    }
    EXPECT_THROW(findSimilar(library, keys), Error);
}

}  // namespace
}  // namespace kumite
