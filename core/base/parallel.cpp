#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace kumite {

void forBlocks(FrameRange range, int blockSize, const std::function<void(FrameRange)>& work) {
    if (range.empty()) return;
    const int blockCount = (range.size() + blockSize - 1) / blockSize;
    std::vector<std::exception_ptr> errors(static_cast<std::size_t>(blockCount));
    std::atomic<int> next{0};
    const auto takeBlocks = [&] {
        for (int block = next++; block < blockCount; block = next++) {
            const int begin = range.begin + block * blockSize;
            try {
                work({begin, std::min(range.end, begin + blockSize)});
            } catch (...) {
                errors[static_cast<std::size_t>(block)] = std::current_exception();
                next = blockCount;
            }
        }
    };
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::jthread> others;
    for (int i = 1; i < std::min(cores, blockCount); ++i)
        others.emplace_back(takeBlocks);
    takeBlocks();
    others.clear();
    for (const std::exception_ptr& error : errors) {
        if (error) std::rethrow_exception(error);
    }
}

}  // namespace kumite
