#include "core/editing/retrieval.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace kumite {
namespace {

using Cost = std::uint16_t;
constexpr Cost kNever = 30000;  ///< more than any sum of differing features
constexpr int kHalfBits = kPoseBitCount / 2;
constexpr std::size_t kHalfSize = std::size_t(1) << kHalfBits;

/// The frames that may lie between one key's frame and the next one's.
struct Gap {
    int wanted = 1, least = 1, most = 1;
};

/// A gap in frames; none is longer than any library.
int frames(double gap) {
    return static_cast<int>(std::min(gap, 1e6));
}

/// The question in the form that the inner loops want.
struct Query {
    std::vector<Gap> gaps;  ///< one per key, the first unused
    int span = 0;           ///< most frames from the first key to the last
    /// Differing features of a key by the lower and by the upper half of a pose's bits.
    std::vector<std::array<std::array<std::uint8_t, kHalfSize>, 2>> tables;

    Query(const KeySequence& keys, const RetrievalSettings& settings) {
        for (std::size_t k = 0; k < keys.bits.size(); ++k) {
            Gap gap;
            if (k > 0) {
                gap.wanted = keys.frames[k] - keys.frames[k - 1];
                gap.least = std::max(1, frames(gap.wanted * settings.fastest));
                gap.most = std::max(gap.least, frames(std::ceil(gap.wanted * settings.slowest)));
                span += gap.most;
            }
            gaps.push_back(gap);
            auto& table = tables.emplace_back();
            for (std::size_t half = 0; half < kHalfSize; ++half) {
                const auto low = static_cast<PoseBits>(half);
                const PoseBits lowMask = settings.mask & (kHalfSize - 1);
                table[0][half] =
                    static_cast<std::uint8_t>(std::popcount((low ^ keys.bits[k]) & lowMask));
                table[1][half] = static_cast<std::uint8_t>(std::popcount(
                    ((low << kHalfBits) ^ keys.bits[k]) & (settings.mask & ~lowMask)));
            }
        }
    }
    std::size_t keys() const { return gaps.size(); }
    Cost differing(std::size_t key, PoseBits bits) const {
        return static_cast<Cost>(tables[key][0][bits & (kHalfSize - 1)] +
                                 tables[key][1][bits >> kHalfBits & (kHalfSize - 1)]);
    }
};

/// A stretch of frames at which the last key may lie with one and the same cost.
struct Place {
    Cost cost = 0;
    Cost rigid = 0;  ///< the cost of its best frame without any change of timing
    int clip = 0;
    FrameRange last;     ///< frames of the clip
    int firstFrame = 0;  ///< before which no key may lie

    auto order() const { return std::tuple(cost, rigid, clip, last.begin); }
    bool operator<(const Place& other) const { return order() < other.order(); }
};

/// out[i] = least of values[i − most … i − least]; kNever outside (van Herk's two running minima).
void windowMinimum(const std::vector<Cost>& values, int least, int most, std::vector<Cost>& out) {
    const int n = static_cast<int>(values.size());
    const int width = most - least + 1;
    static thread_local std::vector<Cost> ahead, behind;
    ahead.resize(values.size());
    behind.resize(values.size());
    for (int begin = 0; begin < n; begin += width) {
        const int end = std::min(n, begin + width);
        Cost running = kNever;
        for (int i = begin; i < end; ++i)
            behind[static_cast<std::size_t>(i)] = running =
                std::min(running, values[static_cast<std::size_t>(i)]);
        running = kNever;
        for (int i = end; i-- > begin;)
            ahead[static_cast<std::size_t>(i)] = running =
                std::min(running, values[static_cast<std::size_t>(i)]);
    }
    out.resize(values.size());
    for (int i = 0; i < n; ++i) {
        const int from = i - most, to = i - least;
        Cost best = kNever;
        if (to >= 0) best = behind[static_cast<std::size_t>(to)];
        if (from >= 0) best = std::min(best, ahead[static_cast<std::size_t>(from)]);
        out[static_cast<std::size_t>(i)] = best;
    }
}

/// Least cost of the whole sequence by the frame of its last key, over `frames`.
void sequenceCosts(std::span<const PoseBits> frames, const Query& query, std::vector<Cost>& costs,
                   std::vector<Cost>& before) {
    costs.resize(frames.size());
    for (std::size_t f = 0; f < frames.size(); ++f)
        costs[f] = query.differing(0, frames[f]);
    for (std::size_t k = 1; k < query.keys(); ++k) {
        windowMinimum(costs, query.gaps[k].least, query.gaps[k].most, before);
        for (std::size_t f = 0; f < frames.size(); ++f) {
            costs[f] =
                static_cast<Cost>(std::min<int>(kNever, before[f] + query.differing(k, frames[f])));
        }
    }
}

Cost rigidCost(std::span<const PoseBits> clip, const Query& query, int firstFrame, int last) {
    int cost = 0;
    for (std::size_t k = query.keys(); k-- > 0; last -= query.gaps[k].wanted) {
        if (last < firstFrame) return kNever;
        cost += query.differing(k, clip[static_cast<std::size_t>(last)]);
    }
    return static_cast<Cost>(cost);
}

/// The best `keep` of some places, in any order.
void keepBest(std::vector<Place>& places, std::size_t keep) {
    if (places.size() <= keep) return;
    std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(keep),
                     places.end());
    places.resize(keep);
}

/// The best places of one piece of a clip; at most `keep` of them.
std::vector<Place> placesIn(std::span<const PoseBits> clip, int clipIndex, FrameRange piece,
                            int firstFrame, const Query& query, std::size_t keep) {
    static thread_local std::vector<Cost> costs, before;
    const int lead = std::max(firstFrame, piece.begin - query.span);
    sequenceCosts(
        clip.subspan(static_cast<std::size_t>(lead), static_cast<std::size_t>(piece.end - lead)),
        query, costs, before);
    std::vector<Place> places;
    const auto cost = [&](int frame) { return costs[static_cast<std::size_t>(frame - lead)]; };
    // Where enough places are cheap, dearer ones need no look.
    static thread_local std::vector<std::size_t> placesOfCost;
    placesOfCost.assign(query.keys() * kPoseBitCount + 2, 0);
    for (int f = piece.begin; f < piece.end; ++f) {
        if (f > piece.begin && cost(f) == cost(f - 1)) continue;
        ++placesOfCost[std::min<std::size_t>(cost(f), placesOfCost.size() - 1)];
    }
    std::size_t limit = 0;
    for (std::size_t seen = placesOfCost[0]; seen < keep && limit + 2 < placesOfCost.size();)
        seen += placesOfCost[++limit];
    for (int f = piece.begin; f < piece.end;) {
        const Cost here = cost(f);
        int end = f + 1;
        while (end < piece.end && cost(end) == here)
            ++end;
        if (here <= limit) {
            Place place{here, kNever, clipIndex, {f, end}, firstFrame};
            for (int last = f; last < end; ++last)
                place.rigid = std::min(place.rigid, rigidCost(clip, query, firstFrame, last));
            places.push_back(place);
        }
        f = end;
    }
    keepBest(places, keep);
    return places;
}

/// The frames of one place's best match: least cost, then least change of timing.
KeyMatch traced(std::span<const PoseBits> clip, const Place& place, const Query& query) {
    // One number for both: whole costs, and far below one of them the change of timing.
    constexpr double kWhole = 1 << 20;
    constexpr double kUnset = std::numeric_limits<double>::infinity();
    struct Cell {
        double value = kUnset;
        int from = -1;
    };
    // Where each key may lie so that the last one lies in the place.
    std::vector<FrameRange> ranges(query.keys(), place.last);
    for (std::size_t k = query.keys() - 1; k > 0; --k) {
        ranges[k - 1].begin = std::max(place.firstFrame, ranges[k].begin - query.gaps[k].most);
        ranges[k - 1].end = std::max(ranges[k - 1].begin, ranges[k].end - query.gaps[k].least);
    }
    std::vector<std::vector<Cell>> cells(query.keys());
    const auto cellAt = [&](std::size_t k, int frame) -> Cell& {
        return cells[k][static_cast<std::size_t>(frame - ranges[k].begin)];
    };
    std::vector<double> stretch;
    for (std::size_t k = 0; k < query.keys(); ++k) {
        const Gap& gap = query.gaps[k];
        stretch.clear();
        for (int frames = gap.least; frames <= gap.most; ++frames)
            stretch.push_back(std::abs(std::log(static_cast<double>(frames) / gap.wanted)));
        cells[k].resize(static_cast<std::size_t>(ranges[k].size()));
        for (int f = ranges[k].begin; f < ranges[k].end; ++f) {
            Cell& cell = cellAt(k, f);
            if (k == 0) cell.value = 0;
            for (int frames = gap.least; k > 0 && frames <= gap.most; ++frames) {
                if (!ranges[k - 1].contains(f - frames)) continue;
                const double value = cellAt(k - 1, f - frames).value +
                                     stretch[static_cast<std::size_t>(frames - gap.least)];
                if (value < cell.value) cell = {value, f - frames};
            }
            cell.value += kWhole * query.differing(k, clip[static_cast<std::size_t>(f)]);
        }
    }
    // Of equally good ends the middle one: the outer ones are where a feature is about to change.
    std::vector<int> ends;
    for (int f = place.last.begin; f < place.last.end; ++f) {
        const double value = cellAt(query.keys() - 1, f).value;
        const double best = ends.empty() ? kUnset : cellAt(query.keys() - 1, ends.front()).value;
        if (value < best) ends.clear();
        if (value <= best) ends.push_back(f);
    }
    int at = ends[ends.size() / 2];
    const double value = cellAt(query.keys() - 1, at).value;
    KeyMatch match{place.clip, std::vector<int>(query.keys()), static_cast<int>(value / kWhole),
                   std::fmod(value, kWhole)};
    if (query.keys() > 1) match.stretch /= static_cast<double>(query.keys() - 1);
    for (std::size_t k = query.keys(); k-- > 0;) {
        match.frames[k] = at;
        at = cellAt(k, at).from;
    }
    return match;
}

bool mostlyShared(const KeyMatch& a, const KeyMatch& b) {
    if (a.clip != b.clip) return false;
    const int shared = std::min(a.frames.back(), b.frames.back()) -
                       std::max(a.frames.front(), b.frames.front()) + 1;
    const int shorter =
        std::min(a.frames.back() - a.frames.front(), b.frames.back() - b.frames.front()) + 1;
    return 2 * shared > shorter;
}

void check(const KeySequence& keys) {
    if (keys.bits.empty()) throw Error("There is no key pose to look for.");
    if (keys.bits.size() > 1000) throw Error("At most 1000 key poses can be looked for.");
    if (keys.frames.size() != keys.bits.size())
        throw Error("Every key pose needs its features and its frame.");
    for (std::size_t k = 1; k < keys.frames.size(); ++k) {
        if (keys.frames[k] <= keys.frames[k - 1])
            throw Error("Key poses must stand in the order of their frames, one per frame.");
    }
}

}  // namespace

void FeatureLibrary::add(std::string name, std::span<const PoseBits> frames) {
    clips.push_back(
        {std::move(name), static_cast<int>(bits.size()), static_cast<int>(frames.size())});
    bits.insert(bits.end(), frames.begin(), frames.end());
}

std::vector<KeyMatch> findSimilar(const FeatureLibrary& library, const KeySequence& keys,
                                  const RetrievalSettings& settings, const Progress& progress) {
    check(keys);
    const Query query(keys, settings);
    const auto framesOf = [&](int clip) {
        const FeatureLibrary::Clip& c = library.clips[static_cast<std::size_t>(clip)];
        return std::span(library.bits)
            .subspan(static_cast<std::size_t>(c.begin), static_cast<std::size_t>(c.frames));
    };
    std::vector<ClipRange> ranges = settings.within;
    for (int c = 0; settings.within.empty() && c < static_cast<int>(library.clips.size()); ++c)
        ranges.push_back({c, {0, library.clips[static_cast<std::size_t>(c)].frames}});
    struct Piece {
        ClipRange range;
        FrameRange frames;  ///< of it, at which the last key may lie
    };
    constexpr int kPiece = 8192;
    std::vector<Piece> pieces;
    for (const ClipRange& range : ranges) {
        for (int begin = range.frames.begin; begin < range.frames.end; begin += kPiece)
            pieces.push_back({range, {begin, std::min(range.frames.end, begin + kPiece)}});
    }
    // More places than results: some will turn out to be the same match.
    const std::size_t keep = 4 * static_cast<std::size_t>(std::max(1, settings.results));
    constexpr int kPiecesAtOnce = 16;
    std::vector<std::vector<Place>> found((pieces.size() + kPiecesAtOnce - 1) / kPiecesAtOnce);
    forBlocks({0, static_cast<int>(pieces.size())}, kPiecesAtOnce, [&](FrameRange block) {
        progress.update(static_cast<double>(block.begin) / static_cast<double>(pieces.size()));
        std::vector<Place>& best = found[static_cast<std::size_t>(block.begin / kPiecesAtOnce)];
        for (int i = block.begin; i < block.end; ++i) {
            const Piece& piece = pieces[static_cast<std::size_t>(i)];
            const auto some = placesIn(framesOf(piece.range.clip), piece.range.clip, piece.frames,
                                       piece.range.frames.begin, query, keep);
            best.insert(best.end(), some.begin(), some.end());
        }
        keepBest(best, keep);
    });
    std::vector<Place> places;
    for (const auto& some : found)
        places.insert(places.end(), some.begin(), some.end());
    keepBest(places, keep);
    std::sort(places.begin(), places.end());

    std::vector<KeyMatch> matches;
    for (const Place& place : places)
        matches.push_back(traced(framesOf(place.clip), place, query));
    std::stable_sort(matches.begin(), matches.end(), [](const KeyMatch& a, const KeyMatch& b) {
        return std::tie(a.mismatches, a.stretch, a.clip, a.frames) <
               std::tie(b.mismatches, b.stretch, b.clip, b.frames);
    });
    std::vector<KeyMatch> kept;
    for (KeyMatch& match : matches) {
        if (static_cast<int>(kept.size()) >= settings.results) break;
        const bool known = std::any_of(kept.begin(), kept.end(), [&](const KeyMatch& other) {
            return mostlyShared(match, other);
        });
        if (!known) kept.push_back(std::move(match));
    }
    return kept;
}

}  // namespace kumite
