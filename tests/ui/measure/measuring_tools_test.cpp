// Angles, radii, lengths along nets, and answers where there is no number: with clicks on a board worked out by hand,
// and on a real one.
#include <QMouseEvent>
#include <QStatusBar>
#include <QtTest>
#include <cmath>
#include <set>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/measure/made_boards.h"
#include "tests/ui/window_fixture.h"
#include "ui/measure/measure_feature.h"

using namespace measuring;
using model::Measurement;
using model::MeasurementKind;
using ui::ActionId;
using ui::BoardView;
using ui::MeasureFeature;
namespace fs = std::filesystem;

namespace {

/// A pad of an outer layer on which nothing else lies but strokes.
bool isLonePad(const model::Document& board, model::ElementId id) {
    const auto& elements = board.elements;
    const model::Layer& layer = board.layer(elements.layer[id.row()]);
    if ((elements.flags[id.row()] & model::kPad) == 0 || !layer.isCopper() || layer.side == model::LayerSide::Inner ||
        elements.kind[id.row()] != model::ElementKind::Area) {
        return false;
    }
    const base::Point centre = board.areas[elements.geometry[id.row()]].placement.origin;
    for (std::size_t row = 0; row < elements.size(); ++row) {
        const base::Box box = board.boxOf(model::ElementId{row});
        const bool isThere =
            box.min.x <= centre.x && centre.x <= box.max.x && box.min.y <= centre.y && centre.y <= box.max.y;
        const bool isDot = (elements.flags[row] & (model::kPad | model::kHole)) != 0;
        if (isThere && isDot && row != id.row() && board.layer(elements.layer[row]).isCopper()) {
            return false;
        }
    }
    return true;
}

}  // namespace

class MeasuringToolsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>(loadMade);
        window().resize(1600, 1000);  // what is caught within pixels is not to reach the neighbour
        QVERIFY(m_fixture->openAndWait("made"));
        showBoth({-4, -1}, {11, 7});
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void threeClicksMakeAnAngleInBothViews() {
        for (BoardView* view : window().views().both()) {
            const QImage before = picture(*view);
            const std::size_t kept = list().size();
            m_fixture->key(Qt::Key_A);
            QVERIFY(window().actions()[ActionId::MeasureAngle].isChecked());
            QVERIFY2(said().contains("corner"), qPrintable(said()));
            click(*view, {0, 0});
            QVERIFY2(said().contains("first arm"), qPrintable(said()));
            click(*view, {6, 0});
            QVERIFY2(said().contains("second arm"), qPrintable(said()));
            click(*view, {0, 6});
            QCOMPARE(list().size(), kept + 1);
            const Measurement& angle = list().back();
            QCOMPARE(angle.kind, MeasurementKind::Angle);
            QVERIFY2(std::abs(angle.angleDeg() - 90.0) < 1e-9, qPrintable(QString::number(angle.angleDeg())));
            QCOMPARE(angle.corner->snap, std::string("centre"));
            QVERIFY2(said().contains("90°"), qPrintable(said()));
            m_fixture->key(Qt::Key_Escape);
            QVERIFY(differingPixels(before, picture(*view)) > 200);
        }
    }

    void theButtonsDoNotWidenTheWindow() {
        QVERIFY2(window().panel("measurements").minimumSizeHint().width() < 400,
                 qPrintable(QString::number(window().panel("measurements").minimumSizeHint().width())));
    }

    void escapeTakesBackClickByClick() {
        m_fixture->key(Qt::Key_A);
        click(flat(), {6, 0});
        click(flat(), {0, 0});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(said().contains("first arm"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(said().contains("corner"));
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::Angle);
        m_fixture->key(Qt::Key_Escape);
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::None);
        QVERIFY(list().empty());
    }

    void twoLinesMakeAnAngle() {
        m_fixture->key(Qt::Key_A, Qt::ShiftModifier);
        for (BoardView* view : window().views().both()) {
            click(*view, {1.5, 3});
            click(*view, {4, 4});
            QVERIFY2(std::abs(list().back().angleDeg() - 135.0) < 1e-9, qPrintable(said()));
            QVERIFY(isAt(*list().back().corner, 3, 3));
        }
        QCOMPARE(list().size(), std::size_t{2});
        click(flat(), {1.5, 3});
        click(flat(), {3, 0});
        QVERIFY2(said().contains("parallel"), qPrintable(said()));
        click(flat(), {0, 6});
        QVERIFY2(said().contains("nothing straight"), qPrintable(said()));
        QCOMPARE(list().size(), std::size_t{2});
    }

    void oneClickMeasuresARadius() {
        m_fixture->key(Qt::Key_R, Qt::ShiftModifier);
        const double half = 1.5 * std::sqrt(0.5);
        for (BoardView* view : window().views().both()) {
            click(*view, {8.5 + half, half});
            QCOMPARE(list().back().kind, MeasurementKind::Radius);
            QVERIFY2(std::abs(list().back().distance() - 1.5e6) < 1.0, qPrintable(said()));
            QVERIFY(isAt(list().back().from, 8.5, 0));
            click(*view, {0.1, 0.1});
            QVERIFY(std::abs(list().back().distance() - 0.5e6) < 1.0);
            QVERIFY2(said().contains("⌀ 1.0000 mm"), qPrintable(said()));
        }
        QCOMPARE(list().size(), std::size_t{4});
        click(flat(), {3, 0});
        QVERIFY2(said().contains("nothing round"), qPrintable(said()));
        QCOMPARE(list().size(), std::size_t{4});
    }

    void whatOneToolHasCaughtIsNothingToTheNext() {
        m_fixture->key(Qt::Key_M);
        move(flat(), {3, 1.5});
        m_fixture->key(Qt::Key_R, Qt::ShiftModifier);
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::Radius);
        click(flat(), {0.1, 0.1});
        QVERIFY(std::abs(list().back().distance() - 0.5e6) < 1.0);
    }

    void lengthsFollowTheCopperOfANet() {
        const QImage before[] = {picture(flat()), picture(solid())};
        m_fixture->key(Qt::Key_J);
        click(flat(), {0, 0});
        QVERIFY2(said().contains("ends"), qPrintable(said()));
        click(flat(), {-3, 0});
        QVERIFY2(said().contains("net M") && said().contains("net N"), qPrintable(said()));
        click(flat(), {6, 4});
        QTRY_COMPARE(list().size(), std::size_t{1});
        const Measurement& length = list().front();
        QCOMPARE(length.kind, MeasurementKind::Length);
        QVERIFY2(std::abs(length.path->length() - 12.2e6) < 1.0, qPrintable(said()));
        QCOMPARE(length.path->holeCount, std::size_t{1});
        QCOMPARE(length.path->perLayer(), (std::vector<std::pair<std::string, double>>{{"top", 6e6}, {"bottom", 4e6}}));
        QVERIFY2(said().contains("assumed thicknesses"), qPrintable(said()));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(differingPixels(before[0], picture(flat())) > 300);
        QVERIFY(differingPixels(before[1], picture(solid())) > 300);
        window().measuring().goTo(0);
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(list().empty());
        window().actions()[ActionId::Redo].trigger();
        const QString path = m_fixture->folder() + "/out.csv";
        window().save(ui::ActionId::ExportMeasurements, path);
        QFile csv(path);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QByteArray text = csv.readAll();
        QVERIFY2(text.contains("along a net,12.200000,") && text.contains("top 6.000000; bottom 4.000000; 1 holes 2.2"),
                 text.constData());
    }

    void aLengthIsFollowedToWhereTheCursorRests() {
        m_fixture->key(Qt::Key_J);
        click(flat(), {0, 0});
        const QImage before = picture(flat());
        move(flat(), {6, 4});
        const auto isFollowed = [&] { return differingPixels(before, picture(flat())) > 3000; };
        QTRY_VERIFY(isFollowed());
        move(flat(), {-3, 0});  // of another net
        QTest::qWait(300);
        QVERIFY(!isFollowed());
        QVERIFY(list().empty());
    }

    void lengthsWithoutAWayAreTold() {
        m_fixture->key(Qt::Key_J);
        click(flat(), {0, 6});
        QVERIFY2(said().contains("no copper of a net"), qPrintable(said()));
        click(flat(), {0, 0});
        click(flat(), {0, 0});
        QTRY_VERIFY2(said().contains("one location"), qPrintable(said()));
        click(flat(), {-3, 0});
        click(flat(), {1, 3});
        QTRY_VERIFY2(said().contains("no copper of net M leads"), qPrintable(said()));
        QVERIFY(list().empty());
    }

    /// The corner of the board is nearer than all points of the copper, and is none of a net.
    void lengthsCatchCopperUnderACornerOfTheBoard() {
        QVERIFY(m_fixture->openAndWait("corner"));
        m_fixture->key(Qt::Key_J);
        click(flat(), {0, 5});
        click(flat(), {3, 5.5});
        QTRY_COMPARE(list().size(), std::size_t{1});
        QVERIFY2(std::abs(list().front().path->length() - 3e6) < 1e3, qPrintable(said()));
    }

    void escapeStopsFollowingANet() {
        m_fixture->key(Qt::Key_J);
        click(flat(), {0, 0});
        click(flat(), {6, 4});
        QVERIFY(window().workspace().isWorking());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().workspace().isWorking());
        QCOMPARE(said(), QString("Stopped"));
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::Length);
        click(flat(), {0, 0});
        click(flat(), {6, 4});
        QTRY_COMPARE(list().size(), std::size_t{1});
    }

    void distancesSayWhatTheyRestOn() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), {-3, 0});
        click(flat(), {-3, 0});
        QVERIFY2(said().contains("both are the same"), qPrintable(said()));
        QVERIFY(list().empty());
        click(flat(), {-3, 0});
        click(flat(), {-3, 4});
        QCOMPARE(list().size(), std::size_t{1});
        for (const char* note : {"both are of net M", "no common layer", "assumed thicknesses: below top"}) {
            QVERIFY2(said().contains(note), qPrintable(said()));
            QVERIFY(details(0).contains(note));
        }
        QVERIFY2(!said().contains("element "), qPrintable(said()));
        QVERIFY(std::abs(list()[0].dz - 1e6) < 1.0 && std::abs(list()[0].dy() - 3e6) < 1.0);
        // Point to point through the same laminate.
        m_fixture->key(Qt::Key_M);
        click(flat(), {-3, 0});
        click(flat(), {-3, 4});
        QVERIFY2(details(1).contains("assumed thicknesses: below top"), qPrintable(details(1)));
    }

    void nothingIsMeasuredWhereASectionPlaneTookTheBoard() {
        BoardView& solid = window().views().solid();
        const model::Box box = window().document()->board;
        const double left = base::toMm(box.min.x);
        const double right = base::toMm(box.max.x);
        const double y = base::toMm(box.min.y);
        m_fixture->key(Qt::Key_M);
        click(solid, {left, y});
        click(solid, {right, y});
        const int whole = window().measurements().rowCount();
        QCOMPARE(whole, 1);
        window().actions()[ActionId::SectionPlane].trigger();
        const std::optional<model::CutSide> cut = ui::Probing::cutSideOf(solid);
        QVERIFY(cut);
        const auto isGone = [&](QPointF mm) {
            return (mm.x() * 1e6 - cut->at.x) * cut->outward.x + (mm.y() * 1e6 - cut->at.y) * cut->outward.y > 0.0;
        };
        const double top = base::toMm(box.max.y);
        std::vector<QPointF> gone;
        for (const QPointF corner : {QPointF(left, y), QPointF(right, y), QPointF(left, top), QPointF(right, top)}) {
            if (isGone(corner)) {
                gone.push_back(corner);
            }
        }
        QVERIFY(gone.size() >= 2);
        click(solid, gone[0]);
        click(solid, gone[1]);
        QCOMPARE(window().measurements().rowCount(), whole);
    }

    void distancesInAPlanAreThoseSeenFromAbove() {
        m_fixture->key(Qt::Key_M);
        click(flat(), {-3, 0});
        click(flat(), {-3, 4});
        QVERIFY(list().back().isPlanar);
        QVERIFY2(said().startsWith("4.0000 mm "), qPrintable(said()));
        QVERIFY(std::abs(list().back().distance() - std::hypot(4e6, 1e6)) < 1.0);
        click(solid(), {-3, 0});
        click(solid(), {0, 0});
        QVERIFY(!list().back().isPlanar);
    }

    void locationsWithoutAPointAreOfTheCopperThatIsSeenThere() {
        m_fixture->key(Qt::Key_M);
        click(flat(), {2, 3.05}, Qt::AltModifier);
        click(flat(), {2, 1.5}, Qt::AltModifier);
        QCOMPARE(list().back().from.snap, std::string("free"));
        QCOMPARE(list().back().from.net, std::string("M"));
        QCOMPARE(list().back().from.layer, std::string("top"));
        QVERIFY(list().back().to.net.empty() && list().back().to.layer.empty());
    }

    void whatHasNoPlaceInTheStackIsMeasuredInThePlane() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        window().actions()[ActionId::ShowAllLayers].trigger();
        click(flat(), {-3, 4});
        click(flat(), {-3, 6});
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY2(details(0).contains("not in the stackup"), qPrintable(details(0)));
        QVERIFY(std::abs(list()[0].distance() - 1e6) < 1.0);
    }

    /// Whichever of its pads is on top while it is clicked.
    void padsOfAHoleAreMeasuredOnTheLayerOfTheOther() {
        QVERIFY(m_fixture->openAndWait("hole"));
        for (const bool isHoleFirst : {false, true}) {
            m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
            for (const bool isHole : {isHoleFirst, !isHoleFirst}) {
                window().layers().showOnly({isHole ? "inner" : "top"});
                click(flat(), {isHole ? 0.3 : 4.0, 0});
            }
            const Measurement& measured = list().back();
            QVERIFY2(std::abs(measured.value() - 2e6) < 1.0, qPrintable(QString::number(measured.value())));
            QVERIFY(measured.from.layer == "top" && measured.to.layer == "top" && measured.notes.empty());
            m_fixture->key(Qt::Key_Escape);
        }
        QCOMPARE(list().size(), std::size_t{2});
    }

    void aSecondClickOnAnElementTakesWhatLiesBeneath() {
        QVERIFY(m_fixture->openAndWait("plane"));
        window().actions()[ActionId::MeasureObjects].trigger();
        for (const QPointF at : {QPointF(-3, 0), QPointF(-1.5, 0)}) {  // the plane alone, and its own track
            click(flat(), at);
            click(flat(), at);
            QVERIFY2(said().contains("both are the same"), qPrintable(said()));
        }
        QVERIFY(list().empty());
        click(flat(), {1, 0});
        click(flat(), {1, 0});
        QCOMPARE(list().size(), std::size_t{1});
        const Measurement& measured = list().front();
        QCOMPARE((std::set{measured.from.net, measured.to.net}), (std::set<std::string>{"G", "N"}));
        QCOMPARE((std::set{measured.from.layer, measured.to.layer}), (std::set<std::string>{"bottom", "top"}));
    }

    void aHoleInItsPadIsMeasuredAsAnAnnularRing() {
        QVERIFY(m_fixture->openAndWait("hole"));
        window().actions()[ActionId::MeasureObjects].trigger();
        for (const bool isHoleFirst : {false, true}) {
            for (const bool isHole : {isHoleFirst, !isHoleFirst}) {
                click(flat(), {isHole ? 0.0 : 0.6, 0}, isHole ? Qt::AltModifier : Qt::NoModifier);
            }
            QVERIFY2(said().startsWith("annular ring 0.8000 mm ("), qPrintable(said()));
            QVERIFY2(!said().contains("overlap"), qPrintable(said()));
            QCOMPARE(said().count("annular ring"), 1);
            const Measurement& ring = list().back();
            QVERIFY(ring.kind == MeasurementKind::Ring && ring.overlap == 0.0 && ring.dz == 0.0);
            QVERIFY2(std::abs(ring.value() - 0.8e6) < 1.0, qPrintable(QString::number(ring.value())));
            QVERIFY(ring.from.layer == "top" && ring.to.layer == "top");
            const model::MeasuredEnd& onHole = isHoleFirst ? ring.from : ring.to;
            QVERIFY(std::abs(std::hypot(onHole.x, onHole.y) - 0.2e6) < 1.0);
        }
        QCOMPARE(list().size(), std::size_t{2});
    }

    void tabTakesTheElementBeneath() {
        QVERIFY(m_fixture->openAndWait("plane"));
        window().actions()[ActionId::MeasureObjects].trigger();
        QVERIFY2(said().contains("Tab"), qPrintable(said()));
        move(flat(), {1, 0});
        QTRY_COMPARE(hoveredNet(), std::string("G"));
        m_fixture->key(Qt::Key_Tab);
        QCOMPARE(hoveredNet(), std::string("N"));
        m_fixture->key(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(hoveredNet(), std::string("G"));
        m_fixture->key(Qt::Key_Tab);
        click(flat(), {1, 0});
        move(flat(), {-3, 0});
        click(flat(), {-3, 0});
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY(list().front().from.net == "N" && list().front().to.net == "G");
        // Where the pointer has moved on, it is over.
        move(flat(), {1, 0});
        click(flat(), {1, 0});
        move(flat(), {-3, 0});
        click(flat(), {-3, 0});
        QVERIFY2(said().contains("both are the same"), qPrintable(said()));
    }

    void thePadThatAClickTakesIsHighlightedAndNotTheHoleInIt() {
        QVERIFY(m_fixture->openAndWait("hole"));
        window().actions()[ActionId::MeasureObjects].trigger();
        const auto isHoleHovered = [this] {
            const auto at = window().selection().hovered();
            return at && (board().elements.flags[at->element.row()] & model::kHole) != 0;
        };
        move(flat(), {0.05, 0});
        QTRY_VERIFY(window().selection().hovered().has_value());
        QVERIFY(!isHoleHovered());
        m_fixture->key(Qt::Key_Tab);
        QVERIFY(isHoleHovered());
    }

    void copperThatCoversNothingIsNamed() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), {9.5, 5});
        QVERIFY2(said().contains("covers nothing") && said().contains("on top "), qPrintable(said()));
        click(flat(), {4000, 4000});  // farther than coordinates reach
        QVERIFY2(said().contains("no element"), qPrintable(said()));
        click(flat(), {9.5, 5});
        click(flat(), {3, -0.9});
        QVERIFY2(said().contains("no element"), qPrintable(said()));
        QVERIFY(list().empty());
    }

    void aGapThatIsShownIsDrawnInBothViews() {
        const QImage before[] = {picture(flat()), picture(solid())};
        ui::ShownSpacing gap;
        gap.spacing = {5e6, {-3e6, 1e6}, {2e6, 1e6}};
        gap.fromLayer = gap.toLayer = model::LayerId{Top};
        window().workspace().showSpacing(gap);
        QVERIFY(differingPixels(before[0], picture(flat())) > 200);
        QVERIFY(differingPixels(before[1], picture(solid())) > 200);
        window().workspace().showSpacing(std::nullopt);
        QCOMPARE(differingPixels(before[0], picture(flat())), 0);
        QVERIFY(list().empty());
    }

    void lengthsOfAWholeBoardAreThoseOfTheModel() {
        m_fixture = std::make_unique<WindowFixture>();
        const fs::path job = fs::path(m_fixture->folder().toStdString()) / "job.tgz";
        fs::copy_file(locations::boards() / "opencellular_breakout.tgz", job);
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        const auto [a, b, path] = pathThroughHoles();
        QVERIFY(a.isValid());
        window().actions()[ActionId::ShowCopperOnly].trigger();
        base::Box both = board().boxOf(a);
        both.include(board().boxOf(b));
        showBoth({both.min.x / 1e6, both.min.y / 1e6}, {both.max.x / 1e6, both.max.y / 1e6});
        m_fixture->key(Qt::Key_J);
        for (const model::ElementId pad : {a, b}) {
            // Other copper may cover it.
            window().layers().showOnly({board().layer(board().elements.layer[pad.row()]).name});
            const base::Point centre = board().areas[board().elements.geometry[pad.row()]].placement.origin;
            click(flat(), {centre.x / 1e6, centre.y / 1e6});
        }
        QTRY_COMPARE(list().size(), std::size_t{1});
        QVERIFY2(std::abs(list()[0].path->length() - path.length) < 1.0,
                 qPrintable(QString("%1, not %2").arg(list()[0].path->length()).arg(path.length)));
        QCOMPARE(list()[0].path->holeCount, path.holeCount);
        if (const QByteArray folder = qgetenv("COPPERSCOPE_SHOTS"); !folder.isEmpty()) {
            (void)window().grab().save(folder + "/length.png");
            (void)picture(solid()).save(folder + "/length-solid.png");
            (void)picture(flat()).save(folder + "/length-flat.png");
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    BoardView& flat() { return window().views().flat(); }
    BoardView& solid() { return window().views().solid(); }
    const model::Document& board() { return *window().document(); }
    const std::vector<Measurement>& list() { return window().measurements().measurements(); }
    /// Of the element that is hovered; empty where none is.
    std::string hoveredNet() {
        const auto at = window().selection().hovered();
        const model::NetId net = at ? board().elements.net[at->element.row()] : model::NetId{};
        return net.isValid() ? board().nets[net.row()].name : "";
    }
    QString said() { return window().statusBar()->currentMessage(); }
    QString details(int row) {
        const auto& model = window().measurements();
        return model.index(row, ui::MeasurementModel::Details).data().toString();
    }
    static bool isAt(const model::MeasuredEnd& end, double xMm, double yMm) {
        return std::hypot(end.x - xMm * 1e6, end.y - yMm * 1e6) < 1.0;
    }
    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }

    /// Two pads whose net leads from one to the other over tracks and holes.
    std::tuple<model::ElementId, model::ElementId, model::NetPath> pathThroughHoles() {
        const auto index = indexed(std::make_shared<const model::Document>(board()));
        for (std::size_t net = 0; net < board().nets.size(); ++net) {
            std::vector<model::ElementId> pads;
            const auto elements = board().elementsOf(model::NetId{net});
            for (const model::ElementId id : elements) {
                if (elements.size() < 100 && isLonePad(board(), id)) {
                    pads.push_back(id);
                }
            }
            base::Progress progress;
            if (pads.size() < 2) {
                continue;
            }
            const auto path = model::pathAlong(*index, {0, model::NetId{net}}, model::BoardElement{0, pads.front()},
                                               model::BoardElement{0, pads.back()}, progress);
            if (path && path->holeCount > 0 && path->areaLength == 0.0) {
                return {pads.front(), pads.back(), *path};
            }
        }
        return {};
    }

    /// From above, with a box of the board (mm) in the middle.
    void showBoth(QPointF min, QPointF max) {
        const ui::BoardPosition location = window().probing().position();
        for (BoardView* view : window().views().both()) {
            view->controller().look(render::NamedView::Top);
            view->controller().show(location.toModel({min.x() * 1e6, min.y() * 1e6}, 2.3e6),
                                    location.toModel({max.x() * 1e6, max.y() * 1e6}, 2.3e6));
        }
    }
    /// Clicks on a place of the uppermost layer, mm.
    QPointF screenOf(BoardView& view, QPointF mm) {
        const double z = static_cast<double>(view.drawnHeights().front().z1) * base::kNmPerMm;
        return *view.controller().screenOf(window().probing().position().toModel({mm.x() * 1e6, mm.y() * 1e6}, z));
    }
    void move(BoardView& view, QPointF mm) {
        const QPointF at = screenOf(view, mm);
        QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    void click(BoardView& view, QPointF mm, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF at = screenOf(view, mm);
        for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            const Qt::MouseButtons held = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
            QMouseEvent event(type, at, view.mapToGlobal(at), Qt::LeftButton, held, modifiers);
            QCoreApplication::sendEvent(&view.canvas(), &event);
        }
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(MeasuringToolsTest)
#include "measuring_tools_test.moc"
