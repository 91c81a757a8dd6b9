#pragma once

#include <QtTest>

/// Qt Test gives up after five seconds, which work in the background takes where the machine has other work too. Here
/// all tries wait a minute: what holds is seen at once, and only what fails takes longer.
inline constexpr int kPatienceMs = 60'000;

#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT((condition), kPatienceMs)
#define QTRY_VERIFY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT((condition), (message), kPatienceMs)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT((actual), (expected), kPatienceMs)
