#pragma once

#include <span>
#include <string>

#include "tests/soak/driver.h"

namespace soak {

/// Something that people do with the window.
struct Action {
    const char* name;
    int weight;       ///< how often, compared with the others
    bool needsBoard;  ///< passed over before the first
    bool isFault;     ///< only where faults are wanted
    void (*run)(Driver& driver, Dice& dice);
};

[[nodiscard]] std::span<const Action> actions();

/// The row of the table that comes next. Depends on the dice alone, not on the window.
[[nodiscard]] const Action& drawAction(Dice& dice, bool withFaults);

}  // namespace soak
