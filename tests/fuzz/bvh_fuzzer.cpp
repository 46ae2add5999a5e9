// libFuzzer on the BVH reader and writer; not built by default:
//   clang++ -std=c++20 -g -O1 -fsanitize=fuzzer,address,undefined -I. -I/usr/include/eigen3
//       tests/fuzz/bvh_fuzzer.cpp core/formats/{bvh_reader,bvh_writer,recording,asf_reader,
//       amc_reader}.cpp core/motion/{euler,kinematics,motion,skeleton}.cpp
//       core/base/{files,parallel,text}.cpp -lfmt -lcrypto -o bvh_fuzzer

#include <cstdint>
#include <cstdlib>

#include "core/base/error.h"
#include "core/formats/bvh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        for (const auto& motion : kumite::readBvh(text, "fuzz").motions) {
            motion->validate();
            const std::string written =
                kumite::bvhText(*motion, motion->frames(), motion->frameTime);
            const kumite::Recording again = kumite::readBvh(written, "again");
            if (again.motions.front()->channels != motion->channels) std::abort();
        }
    } catch (const kumite::InputError& error) {
        if (error.line() < 1 || error.column() < 1) std::abort();
    }
    return 0;
}
