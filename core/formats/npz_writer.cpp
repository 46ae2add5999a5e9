#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/formats/json_text.h"
#include "core/formats/npz.h"

namespace kumite {
namespace {

static_assert(std::endian::native == std::endian::little, "numpy's '<' types");

/// A number of `bytes` bytes, little-endian.
void put(std::string& out, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        out += static_cast<char>((value >> (8 * i)) & 0xff);
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string npyBytes(const NpyArray& array) {
    std::string shape;
    for (const std::size_t size : array.shape)
        shape += fmt::format("{},", size);
    std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}",
                                     array.dtype, shape);
    // Magic, version and length take 10 bytes (12 in version 2); data begin at a multiple of 64.
    const bool isLong = header.size() + 64 > 65000;
    const std::size_t fixedPart = isLong ? 12 : 10;
    header.resize((fixedPart + header.size() + 1 + 63) / 64 * 64 - fixedPart - 1, ' ');
    header += '\n';
    std::string bytes = "\x93NUMPY";
    bytes += static_cast<char>(isLong ? 2 : 1);
    bytes += '\0';
    put(bytes, header.size(), isLong ? 4 : 2);
    return bytes + header + array.data;
}

/// CRC-32 of zip archives (polynomial 0xEDB88320).
std::uint32_t crc32(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> made{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            std::uint32_t value = i;
            for (int bit = 0; bit < 8; ++bit)
                value = (value >> 1) ^ ((value & 1) ? 0xEDB88320u : 0u);
            made[i] = value;
        }
        return made;
    }();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char byte : bytes)
        crc = table[(crc ^ static_cast<unsigned char>(byte)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

/// What a local header and an entry of the directory have in common.
std::string entryHead(const std::string& name, std::uint32_t crc, std::size_t size) {
    std::string head;
    put(head, 20, 2);      // version 2.0
    put(head, 0, 2);       // flags
    put(head, 0, 2);       // stored
    put(head, 0, 2);       // time
    put(head, 0x0021, 2);  // 1 January 1980: the same motion gives the same bytes
    put(head, crc, 4);
    put(head, size, 4);
    put(head, size, 4);
    put(head, name.size(), 2);
    put(head, 0, 2);  // no extra field
    return head;
}

/// UTF-8 as code points; U+FFFD stands for what is none (`asStored` has seen to that).
std::u32string codePoints(const std::string& utf8) {
    std::u32string text;
    for (std::size_t i = 0; i < utf8.size();) {
        const auto lead = static_cast<unsigned char>(utf8[i]);
        const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : 0;
        char32_t point = more == 0 ? lead : lead & (0x3Fu >> more);
        for (int k = 1; k <= more && i + static_cast<std::size_t>(k) < utf8.size(); ++k)
            point = (point << 6) |
                    (static_cast<unsigned char>(utf8[i + static_cast<std::size_t>(k)]) & 0x3Fu);
        text += point;
        i += static_cast<std::size_t>(more) + 1;
    }
    return text;
}

}  // namespace

NpyArray npyFloats(std::string name, std::vector<std::size_t> shape,
                   const std::vector<float>& values) {
    return {std::move(name), "<f4", std::move(shape), bytesOf(values)};
}

NpyArray npyNumber(std::string name, double value) {
    return {std::move(name), "<f8", {}, bytesOf(std::vector<double>{value})};
}

NpyArray npyIntegers(std::string name, const std::vector<std::int32_t>& values) {
    return {std::move(name), "<i4", {values.size()}, bytesOf(values)};
}

NpyArray npyTexts(std::string name, const std::vector<std::string>& texts) {
    std::vector<std::u32string> wide;
    std::size_t width = 1;
    for (const std::string& text : texts) {
        wide.push_back(codePoints(asStored(text)));
        width = std::max(width, wide.back().size());
    }
    std::string data;
    for (std::u32string& text : wide) {
        text.resize(width, U'\0');
        for (const char32_t point : text)
            put(data, point, 4);
    }
    return {std::move(name), fmt::format("<U{}", width), {texts.size()}, std::move(data)};
}

std::string npzBytes(const std::vector<NpyArray>& arrays) {
    std::string archive, directory;
    for (const NpyArray& array : arrays) {
        const std::string name = array.name + ".npy";
        const std::string bytes = npyBytes(array);
        const std::size_t at = archive.size();
        if (at + bytes.size() > std::numeric_limits<std::uint32_t>::max() - 65536)
            throw Error("A .npz file cannot hold more than 4 GB: export a shorter range.");
        const std::string head = entryHead(name, crc32(bytes), bytes.size());
        put(archive, 0x04034b50, 4);
        archive += head + name + bytes;
        put(directory, 0x02014b50, 4);
        put(directory, 20, 2);  // made by version 2.0
        directory += head;
        put(directory, 0, 2);  // comment
        put(directory, 0, 2);  // disk
        put(directory, 0, 2);  // internal attributes
        put(directory, 0, 4);  // external attributes
        put(directory, at, 4);
        directory += name;
    }
    const std::size_t at = archive.size();
    archive += directory;
    put(archive, 0x06054b50, 4);
    put(archive, 0, 2);
    put(archive, 0, 2);
    put(archive, arrays.size(), 2);
    put(archive, arrays.size(), 2);
    put(archive, directory.size(), 4);
    put(archive, at, 4);
    put(archive, 0, 2);
    return archive;
}

std::vector<NpyArray> clipArrays(const Clip& clip, double start, const std::string& suffix) {
    const std::size_t frames = clip.frames.size(), joints = clip.rig->joints.size();
    std::vector<float> rotations;
    rotations.reserve(4 * frames * joints);
    for (const Pose& pose : clip.frames) {
        for (const Eigen::Quaterniond& turn : pose.turns) {
            for (const double part : {turn.w(), turn.x(), turn.y(), turn.z()})
                rotations.push_back(static_cast<float>(part));
        }
    }
    std::vector<std::string> names;
    std::vector<std::int32_t> parents;
    for (const Rig::Joint& joint : clip.rig->joints) {
        names.push_back(joint.name);
        parents.push_back(joint.parent);
    }
    return {npyFloats("positions" + suffix, {frames, joints, 3}, positionsOf(clip).xyz),
            npyFloats("rotations" + suffix, {frames, joints, 4}, rotations),
            npyTexts("names" + suffix, names),
            npyIntegers("parents" + suffix, parents),
            npyNumber("rate" + suffix, clip.rate),
            npyNumber("start" + suffix, start)};
}

}  // namespace kumite
