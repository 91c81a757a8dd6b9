#include "app/commands/render_checks.h"

#include <filesystem>
#include <functional>
#include <string>

#include "app/common/window_option.h"

namespace app {

using base::ErrorCode;
using model::Document;

namespace {

/// What only the other kind of picture has.
base::Status checkMode(const RenderArguments& arguments) {
    const bool is2d = arguments.mode == "2d";
    const struct {
        const char* name;
        bool isGiven;
        bool isOf2d;
    } options[] = {
        {"--window", !arguments.window.empty(), true},
        {"--outlines", arguments.isOutlined, true},
        {"--clip", !arguments.clip.empty(), false},
        {"--explode", arguments.explode != 0.0F, false},
        {"--z-scale", !arguments.zScale.empty(), false},
        {"--mask-colour", !arguments.maskColour.empty(), false},
        {"--silkscreen-colour", !arguments.silkscreenColour.empty(), false},
        {"--finish", !arguments.finish.empty(), false},
        {"--as-designed", arguments.isAsDesigned, false},
        {"--set-thickness", !arguments.board.request.thicknesses.empty() && !arguments.board.saveSession, false},
    };
    for (const auto& option : options) {
        if (option.isGiven && option.isOf2d != is2d) {
            return base::Error{ErrorCode::BadUsage,
                               std::string(option.name) + " is for pictures in " +
                                   (is2d ? "3D, and --mode 2d or --window draws in 2D" : "2D, which --mode 2d draws")};
        }
    }
    return base::Done{};
}

/// What the standard pipeline has no use for.
base::Status checkPipeline(const RenderArguments& arguments) {
    const RenderArguments usual;
    const struct {
        const char* name;
        bool isGiven;
    } options[] = {
        {"--backend", arguments.backend != usual.backend},
        {"--lod", arguments.levels != usual.levels},
        {"--triangulator", arguments.board.triangulator != usual.board.triangulator},
        {"--as-designed", arguments.isAsDesigned},
    };
    for (const auto& option : options) {
        if (arguments.pipeline == "standard" && option.isGiven) {
            return base::Error{ErrorCode::BadUsage, std::string(option.name) +
                                                        " is of the hybrid pipeline; the standard one draws all "
                                                        "elements alike"};
        }
    }
    return base::Done{};
}

/// What the named layers have nothing of.
base::Status checkColours(const RenderArguments& arguments, const Document& document,
                          const std::vector<render::LayerStyle>& styles) {
    const auto isDrawn = [&](const std::function<bool(const model::Layer&)>& isWanted) {
        for (std::size_t row = 0; row < styles.size(); ++row) {
            if (styles[row].isVisible && isWanted(document.layers[row])) {
                return true;
            }
        }
        return false;
    };
    const auto isCover = [](const model::Layer& layer) {
        return layer.isSynthetic && layer.type == model::LayerType::SolderMask;
    };
    const auto isPrint = [](const model::Layer& layer) { return layer.type == model::LayerType::SilkScreen; };
    const auto isCopper = [](const model::Layer& layer) { return layer.isCopper(); };
    const struct {
        const char* option;
        bool isGiven;
        bool isDrawn;
        const char* what;
    } colours[] = {
        {"--mask-colour", !arguments.maskColour.empty(), isDrawn(isCover),
         "solder mask (a layer of openings is none; the solder mask has a layer of its own)"},
        {"--silkscreen-colour", !arguments.silkscreenColour.empty(), isDrawn(isPrint), "silkscreen"},
        {"--finish", !arguments.finish.empty(), isDrawn(isCopper), "copper"},
    };
    for (const auto& colour : colours) {
        if (!arguments.layers.empty() && colour.isGiven && !colour.isDrawn) {
            return base::Error{ErrorCode::BadUsage,
                               std::string(colour.option) + ": the layers that are drawn have no " + colour.what};
        }
    }
    return base::Done{};
}

/// Drawings may lie beside the board.
base::Status checkWindow(const RenderArguments& arguments, const Document& document,
                         const std::vector<render::LayerStyle>& styles) {
    if (arguments.window.empty()) {
        return base::Done{};
    }
    base::Box extent = document.extent;
    for (std::size_t row = 0; row < styles.size(); ++row) {
        const model::Range elements = styles[row].isVisible ? document.layers[row].elements : model::Range{};
        for (std::uint32_t i = 0; i < elements.count; ++i) {
            extent.include(document.boxOf(model::ElementId{elements.first + i}));
        }
    }
    ASSIGN_OR_RETURN(const base::Box window, boxOfWindow(arguments.window));
    return checkMeets(window, extent);
}

}  // namespace

base::Status checkArguments(const RenderArguments& arguments) {
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    if (extension != ".png" && extension != ".PNG") {
        return base::Error{ErrorCode::BadUsage, arguments.output + ": pictures are written as .png"};
    }
    if (!arguments.window.empty()) {
        ASSIGN_OR_RETURN([[maybe_unused]] const base::Box window, boxOfWindow(arguments.window));
    }
    RETURN_IF_ERROR(checkMode(arguments));
    return checkPipeline(arguments);
}

base::Status checkDrawn(const RenderArguments& arguments, const Document& document,
                        const std::vector<render::LayerStyle>& styles) {
    RETURN_IF_ERROR(checkWindow(arguments, document, styles));
    return checkColours(arguments, document, styles);
}

}  // namespace app
