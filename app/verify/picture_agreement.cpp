#include "app/verify/picture_agreement.h"

#include "app/common/headless_device.h"
#include "render/frame/frame_measures.h"
#include "render/frame/offscreen_presenter.h"
#include "render/modelling/board_model.h"
#include "render/scene/layer_style.h"
#include "render/standard/standard_model.h"

namespace app {

using base::Result;

namespace {

constexpr std::uint32_t kSide = 1000;

struct View {
    const char* name;
    render::NamedView direction;
    float zoom;
};
constexpr View kViews[] = {{"top", render::NamedView::Top, 1.0F},
                           {"bottom", render::NamedView::Bottom, 1.0F},
                           {"corner", render::NamedView::Iso, 1.0F},
                           {"top, 8 times", render::NamedView::Top, 8.0F},
                           {"corner, 8 times", render::NamedView::Iso, 8.0F}};

Result<std::vector<render::Image>> draw(render::gpu::Device& device, const model::Document& document,
                                        const auto& board) {
    ASSIGN_OR_RETURN(render::BoardScene scene, render::BoardScene::make(device, board));
    scene.setStyles(render::defaultStyles(document));
    render::OffscreenPresenter presenter(device);
    std::vector<render::Image> pictures;
    for (const View& view : kViews) {
        render::Camera camera;
        camera.fit(board.boxMin, board.boxMax, view.direction, 1.0F);
        camera.focusOnHeight(board.boxMax.z);
        camera.zoom(view.zoom, {0.0F, 0.0F}, 1.0F);
        ASSIGN_OR_RETURN(render::Image picture, presenter.render(scene, camera, {}, kSide, kSide));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

}  // namespace

Result<std::vector<PictureAgreement>> comparePictures(const model::Document& document, const model::Discretisation& how,
                                                      base::Progress& progress) {
    ASSIGN_OR_RETURN(HeadlessDevice opened, HeadlessDevice::open());
    ASSIGN_OR_RETURN(const render::BoardModel hybrid, render::buildBoardModel(document, how, progress));
    ASSIGN_OR_RETURN(const auto drawn, draw(*opened.device, document, hybrid));
    ASSIGN_OR_RETURN(const render::StandardModel standard, render::buildStandardModel(document, how, progress));
    ASSIGN_OR_RETURN(const auto expected, draw(*opened.device, document, standard));
    std::vector<PictureAgreement> all;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        all.push_back({kViews[i].name, render::greyMse(drawn[i], expected[i])});
    }
    return all;
}

}  // namespace app
