#include "app/commands/render_command.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <memory>

#include "app/commands/flat_render.h"
#include "app/commands/render_checks.h"
#include "app/common/board_styles.h"
#include "app/common/console_progress.h"
#include "app/common/headless_device.h"
#include "app/common/memory_limit.h"
#include "model/board/copies.h"
#include "model/text/whole_file.h"
#include "render/frame/transparent.h"
#include "render/gpu/check.h"
#include "render/scene/explosion.h"
#include "render/scene/scene_layers.h"
#include "render/standard/standard_model.h"

namespace app {

using base::ErrorCode;
using base::Result;
using model::Document;

namespace {

model::BoardColours coloursOf(const Document& document, const RenderArguments& arguments) {
    return model::boardColours(
        document, {model::boardColourNamed(arguments.maskColour), model::boardColourNamed(arguments.silkscreenColour),
                   model::surfaceFinishNamed(arguments.finish)});
}

Result<std::vector<render::LayerStyle>> chooseLayers(const Document& document, const RenderArguments& arguments) {
    const render::Appearance appearance = arguments.mode == "2d" ? render::Appearance::Flat : render::Appearance::Solid;
    std::vector<render::LayerStyle> styles =
        render::defaultStyles(document, appearance, render::Palette::Standard, coloursOf(document, arguments));
    if (arguments.hasComponents) {
        showComponents(document, styles);
    }
    if (arguments.layers.empty()) {
        for (std::size_t row = 0; row < styles.size(); ++row) {
            // A raster of shapes is about copper and print, not about the substrate around them.
            styles[row].isVisible = styles[row].isVisible && !(arguments.isMono && document.layers[row].isSynthetic);
        }
        return styles;
    }
    for (render::LayerStyle& style : styles) {
        style.isVisible = false;
    }
    for (const std::string& name : arguments.layers) {
        ASSIGN_OR_RETURN(const model::LayerId layer, findLayer(document, name));
        styles[layer.row()].isVisible = true;
        styles[layer.row()].opacity = 1.0F;
    }
    return styles;
}

/// What to highlight in the board itself and in each step it places, rows as in BoardScene::setStates.
using Highlights = std::vector<render::ElementStates>;

/// A net of a panel is that of all its steps.
Result<Highlights> elementsOfNets(const Document& document, const std::vector<std::string>& names) {
    const std::vector<const Document*> steps = model::distinctSteps(document);
    Highlights elements(steps.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        bool isAnywhere = false;
        for (std::size_t step = 0; step < steps.size(); ++step) {
            if (const model::NetId net = steps[step]->findNet(names[i]); net.isValid()) {
                const std::span<const model::ElementId> own = steps[step]->elementsOf(net);
                elements[step].add(own, names.size() == 1 ? render::kHighlighted : render::highlightedAs(i));
                isAnywhere = true;
            }
        }
        if (!isAnywhere) {
            return base::Error{ErrorCode::BadUsage, "there is no net " + names[i]};
        }
    }
    return elements;
}

Result<render::NamedView> viewOf(const RenderArguments& arguments) {
    const bool is2d = arguments.mode == "2d";
    const std::string& name = arguments.view;
    if (name == "top" || (name.empty() && is2d)) {
        return render::NamedView::Top;
    }
    if (name == "bottom") {
        return render::NamedView::Bottom;
    }
    if (is2d) {
        return base::Error{ErrorCode::BadUsage, "a 2D picture is seen from the top or the bottom, not " + name};
    }
    return render::NamedView::Iso;
}

render::ZScale zScaleOf(const RenderArguments& arguments) {
    return arguments.zScale.empty() ? render::ZScale{} : render::ZScale{arguments.zScale[0], arguments.zScale[1]};
}

render::Backend backendNamed(const std::string& name) {
    constexpr render::Backend kChoices[] = {render::Backend::Mesh, render::Backend::Pull, render::Backend::Impostor,
                                            render::Backend::Raster};
    const auto* const found = std::ranges::find(kChoices, name, render::nameOf);
    return found != std::end(kChoices) ? *found : render::Backend::Auto;
}

render::ViewSettings settingsFor(const RenderArguments& arguments) {
    render::ViewSettings settings;
    settings.backend = backendNamed(arguments.backend);
    settings.is2d = arguments.mode == "2d";
    settings.isFabricated = !settings.is2d && !arguments.isAsDesigned;
    settings.isMono = arguments.isMono;
    settings.isOutlined = arguments.isOutlined;
    settings.isSmoothed = !arguments.isMono;
    settings.explode = arguments.explode;
    settings.zScale = zScaleOf(arguments);
    settings.levels = levelsOf(arguments.levels);
    settings.dim = arguments.nets.empty() ? 0.0F : render::kDimRest;
    if (arguments.isMono) {
        settings.background = glm::vec3(0.0F);
    }
    return settings;
}

/// None if the board is to be whole. `milled` of its elements is milled away.
Result<std::shared_ptr<const render::SectionCut>> cutOf(const RenderArguments& arguments,
                                                        const std::shared_ptr<const Document>& document,
                                                        const std::vector<std::vector<model::ElementId>>& milled) {
    if (arguments.clip.empty()) {
        return std::shared_ptr<const render::SectionCut>();
    }
    base::Progress progress;
    ASSIGN_OR_RETURN(const auto index, model::indexBoard(document, progress));
    const auto location = [&](std::size_t i) {
        return base::PointD{arguments.clip[i] * base::kNmPerMm, arguments.clip[i + 1] * base::kNmPerMm};
    };
    ASSIGN_OR_RETURN(render::SectionCut cut, render::makeSectionCut(*index, render::frameOf(*document).origin,
                                                                    location(0), location(2), milled));
    return std::make_shared<const render::SectionCut>(std::move(cut));
}

/// What is drawn, beside the camera.
struct Scenery {
    std::vector<render::LayerStyle> styles;
    Highlights highlights;
    render::NamedView view;
    std::shared_ptr<const render::SectionCut> cut;
};

render::Camera cameraFor(const RenderArguments& arguments, const render::BoardFrame& model, const Scenery& scenery) {
    const float aspect = static_cast<float>(arguments.width) / static_cast<float>(arguments.height);
    render::Camera camera;
    camera.setOrthographic(arguments.mode == "2d");
    const render::ViewSettings settings = settingsFor(arguments);
    render::Box3 box = render::explodedBox(render::scaledBox(model, settings.zScale), settings.explode);
    if (arguments.hasComponents) {
        render::SceneLayers layers(model);
        layers.styles = scenery.styles;
        box = render::withBodies(box, layers, settings);
    }
    camera.fit(box.min, box.max, scenery.view, aspect);
    if (!arguments.window.empty()) {
        const auto corner = [&](double x, double y) {
            return glm::vec2(x - base::toMm(model.origin.x), y - base::toMm(model.origin.y));
        };
        camera.fitWindow(corner(arguments.window[0], arguments.window[1]),
                         corner(arguments.window[2], arguments.window[3]), model.boxMax.z, aspect, scenery.view);
    }
    return camera;
}

/// What draws.
struct Painter {
    HeadlessDevice opened;
    std::unique_ptr<render::OffscreenPresenter> presenter;
};

/// Makes the pipelines that will most likely be drawn with. Others are made when they are: those of a back end that was
/// asked for, which the device may lack, and those of section planes.
void makeReady(const RenderArguments& arguments, render::OffscreenPresenter& presenter) {
    const render::ViewSettings settings = settingsFor(arguments);
    if (settings.backend != render::Backend::Auto || !arguments.clip.empty()) {
        return;
    }
    const render::Backend likely = arguments.pipeline == "standard" ? render::Backend::Standard
                                   : settings.is2d                  ? render::Backend::Impostor
                                                                    : render::Backend::Auto;
    try {
        presenter.makeReady(likely, settings.isSmoothed);
    } catch (const render::gpu::OutOfMemory&) {
        // Drawing tries again, and says what is missing.
    }
}

Result<Painter> openPainter(const RenderArguments& arguments) {
    ASSIGN_OR_RETURN(HeadlessDevice opened, HeadlessDevice::open());
    auto presenter = std::make_unique<render::OffscreenPresenter>(*opened.device);
    makeReady(arguments, *presenter);
    return Painter{std::move(opened), std::move(presenter)};
}

/// May processors draw it? What they turn out not to draw the device does.
bool mayBeFlat(const RenderArguments& arguments) {
    constexpr std::uint32_t kMostPixels = 16'384;  // along a side; beyond, the device says what is the most
    const RenderArguments usual;
    return arguments.mode == "2d" && arguments.backend == usual.backend && arguments.pipeline == usual.pipeline &&
           arguments.levels == usual.levels && !arguments.isMono && !arguments.isOutlined &&
           std::max(arguments.width, arguments.height) <= kMostPixels;
}

/// Opening a device and compiling its pipelines takes a driver about as long as a board takes to read, so both are done
/// at once; but one after the other where memory is limited, which a driver does not survive running out of, and not
/// before it is asked for where that is not likely.
std::future<Result<Painter>> beginOpening(const RenderArguments& arguments) {
    const bool isLater = isMemoryLimited() || mayBeFlat(arguments);
    const std::launch how = isLater ? std::launch::deferred : std::launch::async | std::launch::deferred;
    return std::async(how, [&arguments] { return openPainter(arguments); });
}

/// The picture as it is asked for, of frames with these settings: `drawFrame(settings)`.
template <class DrawFrame>
Result<render::Image> drawFrames(const RenderArguments& arguments, const Scenery& scenery, const DrawFrame& drawFrame) {
    render::ViewSettings settings = settingsFor(arguments);
    settings.section = scenery.cut;
    if (!arguments.isTransparent) {
        return drawFrame(settings);
    }
    settings.background = glm::vec3(0.0F);
    ASSIGN_OR_RETURN(const render::Image onBlack, drawFrame(settings));
    settings.background = glm::vec3(1.0F);
    ASSIGN_OR_RETURN(const render::Image onWhite, drawFrame(settings));
    return render::withoutBackground(onBlack, onWhite);
}

template <class Model>
Result<render::Image> draw(const RenderArguments& arguments, const Model& board, const Scenery& scenery,
                           std::future<Result<Painter>>& opening) {
    RETURN_IF_ERROR(checkRoomForDevice());  // beside the board
    ASSIGN_OR_RETURN(const Painter painter, opening.get());
    ASSIGN_OR_RETURN(render::BoardScene made, render::BoardScene::make(*painter.opened.device, board));
    render::BoardScene& scene = made;
    scene.setStyles(scenery.styles);
    for (std::uint32_t step = 0; step < scenery.highlights.size(); ++step) {
        scene.setStates(scenery.highlights[step].bytes(), step);
    }
    const render::Camera camera = cameraFor(arguments, board, scenery);
    return drawFrames(arguments, scenery, [&](const render::ViewSettings& settings) {
        return painter.presenter->render(scene, camera, settings, arguments.width, arguments.height);
    });
}

/// Without a device where that is possible.
Result<render::Image> drawFlat(const RenderArguments& arguments, const std::shared_ptr<const render::BoardModel>& board,
                               const Scenery& scenery, std::future<Result<Painter>>& opening) {
    FlatRender flat(board, scenery.styles, scenery.highlights, arguments.width, arguments.height);
    const render::Camera camera = cameraFor(arguments, *board, scenery);
    Result<render::Image> picture = drawFrames(
        arguments, scenery, [&](const render::ViewSettings& settings) { return flat.draw(camera, settings); });
    return picture ? std::move(picture) : draw(arguments, *board, scenery, opening);
}

Result<render::Image> modelAndDraw(const RenderArguments& arguments, const std::shared_ptr<const Document>& document,
                                   Scenery scenery, std::future<Result<Painter>>& opening) {
    ConsoleProgress console;
    if (arguments.pipeline == "standard") {
        const model::Discretisation how = discretisationOf(arguments.board);
        ASSIGN_OR_RETURN(const auto board, render::buildStandardModel(*document, how, console.progress()));
        ASSIGN_OR_RETURN(scenery.cut, cutOf(arguments, document, {}));  // it draws the board as designed
        return draw(arguments, board, scenery, opening);
    }
    ASSIGN_OR_RETURN(render::BoardModel made, modelBoard(*document, arguments.board, console.progress()));
    const auto board = std::make_shared<const render::BoardModel>(std::move(made));
    const bool isFabricated = settingsFor(arguments).isFabricated;
    std::vector<std::vector<model::ElementId>> milled;
    if (isFabricated) {
        milled = render::milledOfSteps(*board);
    }
    ASSIGN_OR_RETURN(scenery.cut, cutOf(arguments, document, milled));
    return mayBeFlat(arguments) ? drawFlat(arguments, board, scenery, opening)
                                : draw(arguments, *board, scenery, opening);
}

Result<std::shared_ptr<const Document>> readDocument(const RenderArguments& arguments) {
    ConsoleProgress console;
    return openDocument(arguments.board, console.progress());
}

base::Status renderToFile(const RenderArguments& arguments) {
    RETURN_IF_ERROR(checkArguments(arguments));
    ASSIGN_OR_RETURN(const render::NamedView view, viewOf(arguments));
    std::future<Result<Painter>> opening = beginOpening(arguments);
    ASSIGN_OR_RETURN(const std::shared_ptr<const Document> document, readDocument(arguments));
    ASSIGN_OR_RETURN(const std::vector<render::LayerStyle> styles, chooseLayers(*document, arguments));
    RETURN_IF_ERROR(checkDrawn(arguments, *document, styles));
    ASSIGN_OR_RETURN(const Highlights highlight, elementsOfNets(*document, arguments.nets));
    ASSIGN_OR_RETURN(const render::Image image,
                     modelAndDraw(arguments, document, {styles, highlight, view, nullptr}, opening));
    ASSIGN_OR_RETURN(const std::string png, render::encodePng(image));
    return model::writeWholeFile(arguments.output, png);
}

}  // namespace

Outcome runRender(const RenderArguments& arguments) {
    RenderArguments effective = arguments;
    if (effective.mode.empty()) {
        effective.mode = effective.window.empty() ? "3d" : "2d";
    }
    RETURN_IF_ERROR(renderToFile(effective));
    return int{kDone};
}

}  // namespace app
