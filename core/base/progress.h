#pragma once

#include <functional>
#include <stop_token>

#include "core/base/error.h"

namespace kumite {

/// How long work tells how far it is and learns that it is no longer wanted. A default-made
/// Progress reports nowhere and never stops. `report` may be called from any thread.
struct Progress {
    std::function<void(double fraction)> report;
    std::stop_token stop;

    /// Throws Cancelled if a stop was asked for; else reports `fraction` in [0, 1].
    void update(double fraction) const {
        if (stop.stop_requested()) throw Cancelled();
        if (report) report(fraction);
    }

    /// The part [from, to] of this progress as a progress of its own.
    Progress part(double from, double to) const {
        Progress inner;
        inner.stop = stop;
        if (report) {
            inner.report = [outer = report, from, to](double fraction) {
                outer(from + (to - from) * fraction);
            };
        }
        return inner;
    }
};

}  // namespace kumite
