#include "ui/views/board_views.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QLineEdit>
#include <QPainter>
#include <QSplitter>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "ui/views/layer_styles.h"

namespace ui {

namespace {

constexpr int kExplodeMs = 250;
constexpr int kEdge = 2;  // pixels: the edge that marks the view in use
constexpr int kLoadLatestMs = 500;

/// Text is typed into it: a field, or what a cell of a table is edited with.
bool isTypedIn(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    const auto* table = parent != nullptr ? qobject_cast<const QAbstractItemView*>(parent->parentWidget()) : nullptr;
    const bool isEditor = table != nullptr && table->viewport() == parent;
    return isEditor || qobject_cast<const QLineEdit*>(&widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

/// A menu or a dialog is open, or somebody types.
bool isKeyboardNeeded() {
    const QWidget* focus = QApplication::focusWidget();
    return QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr ||
           (focus != nullptr && isTypedIn(*focus));
}

/// Something else in our windows has it.
bool isKeyboardBeside(const BoardView& view) {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && focus != &view && !view.isAncestorOf(focus);
}

}  // namespace

BoardViews::BoardViews(GpuContext& context, QWidget* parent)
    : QWidget(parent), m_context(context), m_splitter(new QSplitter) {
    m_views = {new BoardView(context, BoardView::Kind::Flat), new BoardView(context, BoardView::Kind::Solid)};
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, kEdge, 0, 0);
    layout->addWidget(m_splitter);
    m_splitter->setChildrenCollapsible(false);
    for (BoardView* view : m_views) {
        m_splitter->addWidget(view);
        connect(view, &BoardView::timed, this, &BoardViews::onTimed);
        connect(view, &BoardView::deviceLost, this, &BoardViews::onDeviceLost);
        watch(*view);
    }
    connect(m_splitter, &QSplitter::splitterMoved, this, &BoardViews::onSplitterMoved);
    m_load.setSingleShot(true);
    connect(&m_load, &QTimer::timeout, this, &BoardViews::loadScene);
    connect(&context.turns(), &DeviceTurns::came, this, [this](QObject* user) {
        if (user == this) {
            loadInTurn();
        }
    });
    connect(&flat(), &BoardView::timed, this, [this](const render::FrameStats& stats) {
        if (m_load.isActive() && !stats.isOverlayAlone && !stats.isPartial) {
            m_load.start(0);
        }
    });
    m_explosion.setDuration(kExplodeMs);
    m_explosion.setEasingCurve(QEasingCurve::OutCubic);
    connect(&m_explosion, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& value) { applyExplode(value.toFloat()); });
    m_active = m_views[1];
    setArrangement(m_arrangement);
}

void BoardViews::watch(BoardView& view) {
    const CameraController& controller = view.controller();
    connect(&controller, &CameraController::used, this,
            [this, &view] { setActive(m_pointed != nullptr ? *m_pointed : view); });
    connect(&controller, &CameraController::hovered, this, [this, &view] { onPointed(view); });
    connect(&controller, &CameraController::left, this, [this, &view] { onLeft(view); });
}

/// The keyboard comes along from the other view or from a panel, but not from a field that is typed in.
void BoardViews::onPointed(BoardView& view) {
    if (std::exchange(m_pointed, &view) == &view) {
        return;
    }
    const bool isHere =
        QApplication::activeWindow() == window() || std::ranges::any_of(m_views, &BoardView::hasKeyboard);
    if (isHere && !view.hasKeyboard() && !isKeyboardNeeded()) {
        view.takeKeyboard();
        m_keyboardTaker = &view;
    }
}

/// A view that was only crossed gives the keyboard to the one in use: keys go where commands go. Where the desktop has
/// not yet given it what it took, it will.
void BoardViews::onLeft(BoardView& view) {
    m_pointed = nullptr;
    const bool hasTaken = std::exchange(m_keyboardTaker, nullptr) == &view && !isKeyboardBeside(view);
    if (&view != m_active && (hasTaken || view.hasKeyboard()) && !isKeyboardNeeded()) {
        m_active->takeKeyboard();
    }
}

BoardViews::~BoardViews() {
    m_context.turns().end(*this);
    delete m_splitter;  // canvases must not draw a scene that is gone
}

void BoardViews::show(const LoadedBoard& board, const std::vector<LayerAppearance>& appearances) {
    m_board = board;
    m_styles = appearances;
    m_states.clear();
    m_elementColours.clear();
    m_topLayer = {};
    m_contrastLayer = {};
    m_contrastLayers.clear();
    makeScene();
    applyHeights();
    for (BoardView* view : m_views) {
        view->setPosition({board.model->origin});
    }
    setDim(0.0F);
    flat().controller().look(render::NamedView::Top);
    solid().controller().look(render::NamedView::Iso);
}

void BoardViews::setHeights(std::shared_ptr<const model::Document> document) {
    m_board->document = std::move(document);
    applyHeights();
    if (m_scene) {
        m_scene->setHeights(render::frameOf(*m_board->document));
        requestFrame();
    }
}

void BoardViews::setZScale(const render::ZScale& scale) {
    const std::optional<float> before = anchorHeight();
    m_zScale = scale;
    solid().setZScale(scale);
    if (m_board) {
        applyHeights();
    }
    followAnchor(before);
}

void BoardViews::applyHeights() {
    const render::BoardFrame frame = render::frameOf(*m_board->document);
    flat().setBoard(frame.boxMin, frame.boxMax);
    const render::Box3 scaled = render::scaledBox(frame, m_zScale);
    solid().setBoard(scaled.min, scaled.max);
}

/// Flat pictures of a software device need nothing of it there (render::FlatPicture): the first is shown before.
void BoardViews::makeScene() {
    dropScene();  // before the new one is made: the device may not have room for both
    if (m_context.device().isLost()) {
        return;  // that was told
    }
    m_scene =
        std::make_unique<render::BoardScene>(render::BoardScene::makeUnloaded(m_context.device(), m_board->model));
    m_scene->setHeights(render::frameOf(*m_board->document));  // they may have been set since
    applyStates();
    if (m_context.device().caps().isCpu && !flat().isHidden()) {
        showScene(flat());
        m_load.start(kLoadLatestMs);
    } else {
        loadScene();
    }
}

/// Now, or when the device has drawn what it was given before: to copy a board there waits for that.
void BoardViews::loadScene() {
    m_load.stop();
    if (m_context.turns().begin(*this)) {
        loadInTurn();
    }
}

void BoardViews::loadInTurn() {
    if (!m_context.device().caps().isCpu) {
        takeLoaded(m_scene->load());
        return;
    }
    const auto take = [this] {
        if (m_loading.valid()) {
            takeLoaded(m_loading.get());
        }
    };
    m_loading = std::async(std::launch::async, [this, take, scene = m_scene.get()] {
        base::Status loaded = scene->load();
        QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
        return loaded;
    });
}

void BoardViews::takeLoaded(const base::Status& loaded) {
    if (!loaded) {
        dropScene();
        emit troubled(QString::fromStdString(loaded.error().text));
        return;
    }
    for (BoardView* view : m_views) {
        if (!view->hasScene()) {
            showScene(*view);
        }
    }
    m_context.turns().end(*this);
}

void BoardViews::showScene(BoardView& view) {
    view.setModel(m_board->model);
    view.setScene(m_scene.get(), stylesOf(view));
}

void BoardViews::dropScene() {
    m_load.stop();
    if (m_loading.valid()) {
        m_loading.wait();
        m_loading = {};
    }
    m_context.turns().end(*this);
    for (BoardView* view : m_views) {
        view->setScene(nullptr, m_board ? stylesOf(*view) : std::vector<render::LayerStyle>());
        view->setModel(nullptr);
    }
    m_scene.reset();
}

std::vector<render::LayerStyle> BoardViews::stylesOf(const BoardView& view) const {
    const bool isFlat = view.kind() == BoardView::Kind::Flat;
    std::vector<render::LayerStyle> styles = isFlat
                                                 ? flatStyles(*m_board->document, m_styles)
                                                 : solidStyles(*m_board->document, m_styles, m_palette, m_boardColours);
    if (isFlat) {
        putOnTop(styles, *m_board->document, m_topLayer);
    }
    if (isFlat && m_contrastLayers.empty() && m_contrastLayer.isValid()) {
        putInContrast(styles, std::array{m_contrastLayer});
    }
    putInContrast(styles, m_contrastLayers);
    return styles;
}

void BoardViews::setStyles(const std::vector<LayerAppearance>& appearances) {
    // Looks of a board that is about to be shown come again with it.
    if (!m_scene || appearances.size() != m_board->document->layers.size()) {
        return;
    }
    m_styles = appearances;
    applyStyles();
}

void BoardViews::applyStyles() {
    for (BoardView* view : m_views) {
        view->setStyles(stylesOf(*view));
    }
}

void BoardViews::setTopLayer(model::LayerId layer) {
    m_topLayer = layer;
    if (m_scene) {
        flat().setStyles(stylesOf(flat()));
    }
}

void BoardViews::setContrastLayer(model::LayerId layer) {
    if (layer == m_contrastLayer) {
        return;
    }
    m_contrastLayer = layer;
    if (m_scene) {
        flat().setStyles(stylesOf(flat()));
    }
}

void BoardViews::setContrastLayers(std::vector<model::LayerId> layers) {
    if (layers == m_contrastLayers) {
        return;
    }
    m_contrastLayers = std::move(layers);
    if (m_scene) {
        applyStyles();
    }
}

void BoardViews::applyStates() {
    if (!m_scene) {
        return;
    }
    m_scene->setPalette(m_elementColours);
    for (std::uint32_t step = 0; step < m_states.size(); ++step) {
        m_scene->setStates(m_states[step].bytes(), step);
    }
}

void BoardViews::setStates(ElementStateLists states) {
    m_states = std::move(states);
    applyStates();
}

void BoardViews::setArrangement(Arrangement arrangement) {
    m_arrangement = arrangement;
    m_splitter->setOrientation(arrangement == Arrangement::Stacked ? Qt::Vertical : Qt::Horizontal);
    flat().setVisible(arrangement != Arrangement::Solid);
    solid().setVisible(arrangement != Arrangement::Flat);
    if (m_pointed != nullptr && m_pointed->isHidden()) {
        m_pointed = nullptr;  // not every platform says that the pointer left it
    }
    if (arrangement == Arrangement::Flat || arrangement == Arrangement::Solid) {
        setActive(arrangement == Arrangement::Flat ? flat() : solid());
    } else {
        divide(m_flatShare);
    }
    update();
}

void BoardViews::divide(double flatShare) {
    m_flatShare = flatShare;
    if (!flat().isHidden() && !solid().isHidden()) {
        constexpr double kAll = 2000.0;  // whatever the room
        m_splitter->setSizes({qRound(flatShare * kAll), qRound((1.0 - flatShare) * kAll)});
        update();
    }
}

void BoardViews::onSplitterMoved() {
    const QList<int> sizes = m_splitter->sizes();
    m_flatShare = static_cast<double>(sizes[0]) / std::max(sizes[0] + sizes[1], 1);
    update();
    emit divided(m_flatShare);
}

void BoardViews::setActive(BoardView& view) {
    if (std::exchange(m_active, &view) != &view) {
        update();
    }
}

void BoardViews::reveal(const BoardView& view) {
    if (isVisible() && view.isHidden()) {  // else no board is shown
        emit bothWanted();
    }
}

void BoardViews::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const bool isSplit = m_arrangement == Arrangement::SideBySide || m_arrangement == Arrangement::Stacked;
    for (const BoardView* view : m_views) {
        if (isSplit && view == m_active && view->isVisible()) {
            const QPoint corner = view->mapTo(this, QPoint(0, 0));
            painter.fillRect(QRect(corner.x(), corner.y() - kEdge, view->width(), kEdge),
                             palette().color(QPalette::Highlight));
        }
    }
}

void BoardViews::explode(float by) {
    m_explosion.stop();
    m_explosion.setStartValue(m_exploded);
    m_explosion.setEndValue(by);
    m_explosion.start();
}

void BoardViews::setExplode(float by) {
    m_explosion.stop();
    applyExplode(by);
}

void BoardViews::applyExplode(float by) {
    const std::optional<float> before = anchorHeight();
    m_exploded = by;
    solid().setExplode(by);
    followAnchor(before);
}

std::optional<float> BoardViews::anchorHeight() {
    const model::LayerId anchor = m_anchor();
    const std::vector<render::ZRange> heights = solid().drawnHeights();
    return anchor.isValid() && anchor.row() < heights.size() ? std::optional(heights[anchor.row()].z1) : std::nullopt;
}

void BoardViews::followAnchor(std::optional<float> before) {
    if (const std::optional<float> after = anchorHeight(); before && after) {
        solid().controller().lift(*after - *before);
    }
}

void BoardViews::onTimed(const render::FrameStats& stats) {
    m_isUntried = m_isUntried && !stats.isByDevice;
    if (!stats.isOverlayAlone) {
        emit timed(stats);
    }
}

void BoardViews::onDeviceLost() {
    if (!m_context.device().isLost()) {
        return;  // told twice of one loss
    }
    if (std::exchange(m_isUntried, true)) {
        emit troubled(tr("The graphics device keeps failing. Please start Copperscope again."));
        return;
    }
    dropScene();
    for (BoardView* view : m_views) {
        view->releaseDevice();
    }
    emit deviceGoes();
    if (const base::Status renewed = m_context.renewDevice(); !renewed) {
        emit troubled(tr("The graphics device failed. %1").arg(QString::fromStdString(renewed.error().text)));
        return;
    }
    for (BoardView* view : m_views) {
        view->takeCanvas();
    }
    emit troubled(tr("The graphics device failed and was started again."));
    if (m_board) {
        makeScene();
    }
}

}  // namespace ui
