#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"
#include "render/frame/offscreen_presenter.h"
#include "render/frame/png.h"

namespace app {

struct RenderArguments {
    BoardArguments board;
    std::string output;
    std::string view;  ///< top, bottom, iso; empty: iso in 3D, top in 2D
    std::uint32_t width = 1600;
    std::uint32_t height = 1000;
    std::string mode;  ///< 2d, 3d; empty: 3d, or 2d with a window
    std::string backend = "auto";
    std::string pipeline = "hybrid";  ///< or "standard"
    std::vector<std::string> layers;  ///< only these, fully opaque; empty: as in the window
    std::string maskColour;           ///< in 3D, as model::boardColourNames; empty: as the job says, or the common one
    std::string silkscreenColour;     ///< likewise
    std::string finish;               ///< as model::surfaceFinishNames, likewise
    std::vector<std::string> nets;    ///< highlighted, everything else dimmed
    float explode = 0.0F;
    std::vector<float> zScale;     ///< of copper and of everything else; empty: as it is
    std::string levels = "error";  ///< of detail; or "paper", "coarse"
    std::vector<double> window;    ///< x0, y0, x1, y1 in millimetres of the job's coordinates, in 2D
    std::vector<double> clip;  ///< x0, y0, x1, y1 likewise: cut by a section plane there, what is to the left is gone
    bool isMono = false;
    bool isOutlined = false;
    bool isTransparent = false;  ///< the picture has no background
    bool hasComponents = false;  ///< the bodies of components too
    bool isAsDesigned = false;   ///< in 3D with what is milled away; the standard pipeline and 2D always are
};

/// `copperscope render BOARD -o out.png`: a picture.
[[nodiscard]] Outcome runRender(const RenderArguments& arguments);

}  // namespace app
