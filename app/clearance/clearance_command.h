#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/clearance/clearance_map_command.h"
#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct ClearanceArguments {
    BoardArguments board;
    std::size_t worst = 100;
    std::string below;              ///< a length; empty: list the smallest, whatever they are
    std::string layer;              ///< empty: all copper layers
    std::vector<std::string> nets;  ///< two names, or none
    std::string format = "text";    ///< as model::reportFormatOf has it
    std::string output;             ///< a file for the report; empty: stdout
    std::string rules;              ///< a file of rules, "default", or empty: no rules
    bool printsRules = false;       ///< prints the rules as a file, and checks nothing
    std::string tolerance;          ///< of the limits of rules, a length; empty: as the rules say
    bool isThroughStackup = false;  ///< distances in space, see through_stackup.h
    bool allowsIncomplete = false;  ///< what could not be checked is no failure
    std::string waivers;            ///< a file of waivers; empty: none
    std::string newWaivers;         ///< then nothing is reported, but all findings are waived in this file
    std::string reason;             ///< of new waivers
    std::string author;
    ClearanceMapArguments map;  ///< with a file: that is made and nothing is listed
};

/// `copperscope clearance BOARD [--below 100um] [--layer NAME] [--nets A,B]`: the smallest clearances between nets, on
/// stdout or in a file; with `--rules FILE` what every rule says of the board (model::RuleTable), findings that
/// `--waivers FILE` accepts apart. Returns kTooClose if --below was given and anything is closer, or if a rule is
/// broken; also if not everything could be checked, of rules or below.
[[nodiscard]] Outcome runClearance(const ClearanceArguments& arguments);

}  // namespace app
