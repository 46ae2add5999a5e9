#pragma once

// Qt is built without the thread sanitizer, which therefore does not see that what one thread puts
// into another's queue of events happens before that other takes it out, and would call every
// delivery a race. These two say it; in all other builds they are nothing.

#if defined(__SANITIZE_THREAD__)  // GCC; Clang says it otherwise
#define KUMITE_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define KUMITE_THREAD_SANITIZER
#endif
#endif

#ifdef KUMITE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace kumite::studio {

#ifdef KUMITE_THREAD_SANITIZER
inline char queueEdge;  ///< its address alone counts
#endif

/// Say before something is put into the queue.
inline void putsIntoQueue() {
#ifdef KUMITE_THREAD_SANITIZER
    __tsan_release(&queueEdge);
#endif
}

/// Say first in what is taken out of the queue, before it looks at anything.
inline void takenFromQueue() {
#ifdef KUMITE_THREAD_SANITIZER
    __tsan_acquire(&queueEdge);
#endif
}

}  // namespace kumite::studio
