#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct AgreeArguments {
    BoardArguments board;  ///< how both are read; its path is not used
    std::string a;
    std::string b;
    std::string formatA;  ///< BoardFormat::key, over that of `board`; empty: as there
    std::string formatB;
    std::string tolerance;                 ///< AgreementRequest::tolerance; empty: that of the type
    std::optional<double> allowedPercent;  ///< AgreementRequest::allowed; none: nothing
    std::size_t most = 10;                 ///< how many differences are listed of each comparison
    std::vector<std::string> aspects;      ///< only these; empty: all
    bool asJson = false;
    bool allowsIncomplete = false;  ///< exit code 0 also where not all of a job could be read
};

/// `copperscope agree A B`: whether two jobs describe the same board, on stdout; exit code 4 if they do not, or if that
/// is said of a part of them alone.
///
/// JSON: {"a", "b", "agree", "compared", "complete", "shift_nm": [x, y], "comparisons": [{"aspect", "verdict",
/// "layers": [a, b] or null, "counts": [a, b] or null, "note", "area_nm2": [a, b], "only_nm2": [a, b], "share",
/// "box_nm": [x0, y0, x1, y1] or null, "differing", "differences": [{"text", "at_nm": [x, y] or null}]}]}; the areas of
/// layers and outlines only. `counts` of the stackup are copper layers.
[[nodiscard]] Outcome runAgree(const AgreeArguments& arguments);

}  // namespace app
