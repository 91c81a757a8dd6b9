#include "ui/element/element_picture.h"

#include <QPainter>
#include <algorithm>

#include "model/base/background.h"
#include "model/board/single_element.h"
#include "ui/canvas/picture.h"

namespace ui {

namespace {

constexpr int kWidth = 140;
constexpr int kHeight = 110;
constexpr int kGap = 4;
constexpr int kSettleMs = 60;
/// One for both pictures: they are small, and each back end has pipelines of its own.
constexpr render::Backend kBackend = render::Backend::Pull;

/// Bodies of components are nearly as dark as the ground of the views: a picture of them has another one.
constexpr float kLeastContrast = 2.0F;
constexpr glm::vec3 kLightGround{0.78F, 0.80F, 0.83F};

glm::vec3 rgb(const QColor& colour) {
    return {static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()), static_cast<float>(colour.blueF())};
}

/// How bright an sRGB colour is, 0 to 1.
float brightnessOf(const glm::vec3& colour) {
    return glm::dot(glm::pow(colour, glm::vec3(2.2F)), {0.2126F, 0.7152F, 0.0722F});
}

/// As WCAG counts it: 1 for colours that are equally bright, 21 for black and white.
float contrastOf(const glm::vec3& a, const glm::vec3& b) {
    const auto [dark, light] = std::minmax({brightnessOf(a), brightnessOf(b)});
    return (light + 0.05F) / (dark + 0.05F);
}

/// All of the element, whatever the faces of its board are.
render::Camera cameraFor(const model::Document& alone, const render::BoardModel& model, int view, QSize pixels) {
    const model::ZRange heights = alone.heightsOf(model::ElementId{0});
    const glm::vec3 low(model.boxMin.x, model.boxMin.y, base::toMm(heights.bottom));
    const glm::vec3 high(model.boxMax.x, model.boxMax.y, base::toMm(heights.top));
    const float aspect = static_cast<float>(pixels.width()) / static_cast<float>(pixels.height());
    const bool isFlat = view == ElementPicture::Flat;
    render::Camera camera;
    camera.setOrthographic(isFlat);
    camera.fit(low, high, isFlat ? render::NamedView::Top : render::NamedView::Iso, aspect);
    return camera;
}

/// The element with as many nodes as can be drawn; null if none of its nodes can be left out.
std::shared_ptr<const model::Document> small(const model::Document& document, model::ElementId element) {
    if (model::nodeCountOf(document, element) <= ElementPicture::kMostNodes) {
        return model::elementAlone(document, element);
    }
    const model::Box box = document.boxOf(element);
    const auto size = std::max(box.width(), box.height());
    for (auto detail = size / (2 * kWidth); detail < size; detail *= 2) {
        const auto alone = model::elementAlone(document, element, static_cast<model::Nm>(detail));
        if (model::nodeCountOf(*alone, model::ElementId{0}) <= ElementPicture::kMostNodes) {
            return alone;
        }
    }
    return nullptr;
}

}  // namespace

ElementPicture::ElementPicture(GpuContext& context, SelectionModel& selection, LayerModel& layers, QWidget* parent)
    : QWidget(parent), m_context(context), m_selection(selection), m_layers(layers) {
    setMaximumHeight(kHeight);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettleMs);
    connect(&m_settle, &QTimer::timeout, this, qOverload<>(&QWidget::update));
    setToolTip(tr("The element alone, from the top and as an isometric view, with its true height"));
    connect(&m_modelling.background(), &Background::finished, this, &ElementPicture::takeModelled);
    connect(&context.turns(), &DeviceTurns::came, this, [this](QObject* user) {
        if (user == this) {
            drawInTurn();
            update();
        }
    });
    connect(&selection, &SelectionModel::selectionChanged, this, &ElementPicture::setStale);
    connect(&layers, &LayerModel::stylesChanged, this, &ElementPicture::setStale);
    setStale();
}

QSize ElementPicture::sizeHint() const {
    return {2 * kWidth + kGap, kHeight};
}

void ElementPicture::setStale() {
    m_isStale = true;
    m_modelling.cancel();
    m_modelled.reset();
    m_images = {};
    m_reason.clear();
    m_settle.start();
    setVisible(m_selection.current().has_value());
    update();
}

QRect ElementPicture::locationOf(int view) const {
    const int width = std::max(1, std::min(kWidth, (this->width() - kGap) / 2));
    return {view * (width + kGap), 0, width, std::max(1, height())};
}

QSize ElementPicture::pixels() const {
    return (QSizeF(locationOf(Flat).size()) * devicePixelRatioF()).toSize();
}

void ElementPicture::paintEvent(QPaintEvent*) {
    if (m_isStale && !m_settle.isActive()) {
        startModelling();
    } else {
        drawInTurn();
    }
    QPainter painter(this);
    if (!m_reason.isEmpty()) {
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, m_reason);
        return;
    }
    for (int view = 0; view < ViewCount; ++view) {
        painter.drawImage(locationOf(view), m_images[static_cast<std::size_t>(view)]);
    }
}

void ElementPicture::startModelling() {
    m_isStale = false;
    const auto current = m_selection.current();
    if (!current) {
        return;
    }
    makePresenter();
    const auto model = [document = m_selection.sharedStepOf(*current), element = current->element,
                        pipelines = m_pipelines](base::Progress& progress) -> base::Result<Modelled> {
        Modelled out{small(*document, element), std::nullopt, document->elements.layer[element.row()].row()};
        if (out.alone) {
            ASSIGN_OR_RETURN(out.model, render::buildBoardModel(*out.alone, {}, progress));
        }
        if (pipelines.valid()) {
            pipelines.wait();
        }
        return out;
    };
    m_modelling.run(model, tr("Modelling an element"), tr("No picture: there is not enough memory"));
}

/// Making its pipelines takes longer than drawing, so it is kept, and they are made in the background.
void ElementPicture::makePresenter() {
    if (m_presenter || m_context.device().isLost()) {
        return;
    }
    m_presenter.emplace(m_context.device());
    m_pipelines = std::async(std::launch::async, [this] {
                      base::becomeBackground();
                      m_presenter->makeReady(kBackend, true);
                  }).share();
}

void ElementPicture::releaseDevice() {
    if (m_pipelines.valid()) {
        m_pipelines.wait();
    }
    m_presenter.reset();
}

void ElementPicture::takeModelled() {
    if (auto modelled = m_modelling.take()) {
        m_modelled = std::move(*modelled);
        m_pixels = {};
    } else {
        m_reason = QString::fromStdString(modelled.error().text);
    }
    update();
}

/// Now, or when the device has drawn what it was given before.
void ElementPicture::drawInTurn() {
    const QSize wanted = pixels();
    const bool isWanted = m_modelled && wanted != m_pixels;
    if (isWanted && !m_context.turns().begin(*this)) {
        return;
    }
    if (isWanted) {
        m_pixels = wanted;
        m_images = {};
        m_reason = drawModelled(wanted);
    }
    m_context.turns().end(*this);
}

QString ElementPicture::drawModelled(QSize pixels) {
    if (m_context.device().isLost()) {
        return tr("No picture: the graphics device failed");
    }
    if (!m_modelled->model) {
        return tr("Too large for a picture");
    }
    auto scene = render::BoardScene::make(m_context.device(), *m_modelled->model);
    if (!scene) {
        return QString::fromStdString(scene.error().text);
    }
    makePresenter();  // the device may be another one by now
    m_pipelines.wait();
    Picture picture;
    picture.settings.backend = kBackend;
    picture.scene = &*scene;
    const QColor colour = m_layers.effectiveStyles()[m_modelled->layer].colour;
    picture.styles = {{rgb(colour), 1.0F, true}};
    if (contrastOf(rgb(colour), picture.settings.background) < kLeastContrast) {
        picture.settings.background = kLightGround;
    }
    for (const View view : {Flat, Solid}) {
        picture.settings.is2d = view == Flat;
        const render::Camera camera = cameraFor(*m_modelled->alone, *m_modelled->model, view, pixels);
        const auto image = drawPicture(*m_presenter, picture, camera, pixels);
        if (!image) {
            m_images = {};
            return QString::fromStdString(image.error().text);
        }
        m_images[view] = *image;
    }
    return {};
}

}  // namespace ui
