#include "studio/app/comfort.h"

#include <algorithm>

namespace kumite::studio {

namespace {

int size = 100;
bool reduced = false;

}  // namespace

void setTextSize(int percent) {
    size = std::clamp(percent, 100, 200);
}

int textSize() {
    return size;
}

int withTextSize(int pixels) {
    return pixels * size / 100;
}

void setMotionReduced(bool is) {
    reduced = is;
}

bool isMotionReduced() {
    return reduced;
}

}  // namespace kumite::studio
