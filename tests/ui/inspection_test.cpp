// A board is inspected from end to end, as a person does it: with keys and clicks.
// COPPERSCOPE_SHOTS names a folder for pictures of the window on the way.

#include <QComboBox>
#include <QLineEdit>
#include <QMouseEvent>
#include <QScreen>
#include <QSlider>
#include <QtTest>
#include <fstream>
#include <sstream>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/element/element_panel.h"
#include "ui/nets/nets_panel.h"
#include "ui/search/search_box.h"
#include "ui/shell/message_bar.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_view.h"

using model::Measurement;
using ui::ActionId;
using ui::BoardView;
using ui::ClearancePanel;
using ui::StackupModel;
namespace fs = std::filesystem;

namespace {

constexpr double kReadNm = 3.0;  // coordinates and diameters are rounded to nanometres as they are read

/// A board, and two round pads on top of it by their nets. How far apart they are was worked out from the job's files.
struct Inspected {
    const char* file;
    const char* netA;
    const char* netB;
    double centresMm;
    double edgesMm;
};
constexpr Inspected kInspected[] = {
    {"parallella_meta_carrier_odb_rev1.tgz", "EA_WAIT_WR_IN_N2", "EA_DATA_OUT_P14", 1.27, 0.635},
    {"opencellular_breakout.tgz", "IRQ_INT", "SYNC_INT#", 2.54, 0.9652}};

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QImage picture(BoardView& view) {
    const base::Result<QImage> image = view.grabPicture();
    return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
}

void send(BoardView& view, QEvent::Type type, QPointF at) {
    const Qt::MouseButtons held = type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton;
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, view.mapToGlobal(at), button, held, Qt::NoModifier);
    QCoreApplication::sendEvent(&view.canvas(), &event);
}

void click(BoardView& view, QPointF at) {
    send(view, QEvent::MouseMove, at);
    send(view, QEvent::MouseButtonPress, at);
    send(view, QEvent::MouseButtonRelease, at);
}

/// The cursor goes away: nothing is hovered any more.
void leave(BoardView& view) {
    QEvent event(QEvent::Leave);
    QCoreApplication::sendEvent(&view.canvas(), &event);
}

double distanceToMiddle(BoardView& view, QPointF at) {
    const QSizeF size = view.controller().viewport();
    return QLineF(at, QPointF(size.width() / 2, size.height() / 2)).length();
}

}  // namespace

class InspectionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        const fs::path board = locations::boardsNamed({kInspected[0].file, kInspected[1].file}).front();
        m_inspected = board.filename() == kInspected[0].file ? &kInspected[0] : &kInspected[1];
        m_job = fs::path(m_fixture->folder().toStdString()) / "job.tgz";  // sessions are written beside it
        fs::copy_file(board, m_job);
        openJob();
    }
    void init() {
        if (window().document() == nullptr || window().document()->job.name != m_name) {
            openJob();
        }
        while (window().selection().clearStep()) {
        }
        window().messageBar().hide();
        // Both pads in the middle, the copper of their layer alone.
        window().layers().showOnly({board().layer(board().elements.layer[m_a.row()]).name});
        model::Box both = board().boxOf(m_a);
        both.include(board().boxOf(m_b));
        for (BoardView* view : window().views().both()) {
            view->controller().look(render::NamedView::Top);
            view->controller().show(place().toModel(base::toDouble(both.min), heightOf(m_a)),
                                    place().toModel(base::toDouble(both.max), heightOf(m_a)));
        }
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theStackIsOpenedSteppedThroughAndExported() {
        window().layers().restoreDefaults();
        m_fixture->key(Qt::Key_6, Qt::ControlModifier);
        QTRY_VERIFY(!stackupView().visibleRegion().isEmpty());
        shoot("stackup");
        const std::vector<std::size_t> rows = rowsWithLayers();
        const QImage before[] = {picture(flat()), picture(solid())};
        clickBand(rows[3], Qt::AltModifier);
        QCOMPARE(window().layers().soloLayer(), board().stackup.rows[rows[3]].layer);
        QVERIFY(differingPixels(before[0], picture(flat())) > 200);
        QVERIFY(differingPixels(before[1], picture(solid())) > 200);
        for (std::size_t row = rows[3] + 1; row < board().stackup.rows.size(); ++row) {
            QTest::keyClick(&stackupView(), Qt::Key_Down);
            QCOMPARE(window().stackupPanel().table().currentIndex().row(), static_cast<int>(row));
        }
        QTest::keyClick(&stackupView(), Qt::Key_Up);
        shoot("stack-one-layer");
        QVERIFY(window().layers().soloLayer().isValid());
        m_fixture->key(Qt::Key_Escape);  // all are shown again
        QCOMPARE(differingPixels(before[0], picture(flat())), 0);
        QCOMPARE(differingPixels(before[1], picture(solid())), 0);

        for (const char* name : {"stack.svg", "stack.csv"}) {
            const QString path = m_fixture->folder() + "/" + name;
            window().save(ui::ActionId::ExportStackup, path);
            const QByteArray written = contentsOf(path);
            for (const std::size_t row : rows) {
                QVERIFY(written.contains(board().stackup.rows[row].name.c_str()));
            }
        }
    }

    void anAssumedThicknessIsTypedSeenAndTakenBack() {
        const auto& stack = board().stackup.rows;
        const auto assumed = std::ranges::find_if(stack, [](const model::StackupRow& row) {
            return row.source == model::Source::Assumed && row.layer.isValid();
        });
        QVERIFY(assumed != stack.end());
        const model::LayerId layer = assumed->layer;
        const std::vector<render::ZRange> before = solid().drawnHeights();
        window().showPanel("stackup");
        type(static_cast<int>(assumed - stack.begin()), "0.3 mm");
        QCOMPARE(board().layer(layer).thickness, 300'000);
        const render::ZRange after = solid().drawnHeights()[layer.row()];
        QVERIFY(std::abs(double(after.z1) - double(after.z0) - 0.3) < 1e-5);
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        const std::vector<render::ZRange> again = solid().drawnHeights();
        QCOMPARE(again[layer.row()].z0, before[layer.row()].z0);
        QCOMPARE(again[layer.row()].z1, before[layer.row()].z1);
    }

    void eachViewFollowsTheOtherWhenAsked() {
        const std::tuple<BoardView&, BoardView&, Qt::Key> ways[] = {{flat(), solid(), Qt::Key_3},
                                                                    {solid(), flat(), Qt::Key_2}};
        for (const auto& [from, to, key] : ways) {
            init();
            to.controller().fit();
            const float fitted = to.controller().mmPerPixel();
            click(from, screenOf(from, m_a));
            QCOMPARE(netSelected(), netOf(m_a));
            QCOMPARE(to.controller().mmPerPixel(), fitted);
            chord(key);
            click(from, screenOf(from, m_b));
            QCOMPARE(netSelected(), netOf(m_b));
            QVERIFY(to.controller().mmPerPixel() < fitted * 0.9F);
            QVERIFY(distanceToMiddle(to, screenOf(to, m_b)) < 0.2 * to.width());
            leave(from);
            const QImage highlighted = picture(to);
            shoot(key == Qt::Key_3 ? "probe-2d-to-3d" : "probe-3d-to-2d");
            chord(key);
            window().selection().clearStep();
            QVERIFY(differingPixels(highlighted, picture(to)) > 50);
        }
    }

    void tablesAndViewsFollowWhenAsked() {
        window().showPanel("nets");
        QTRY_VERIFY(window().nets().isArranged());
        click(solid(), screenOf(solid(), m_a));
        QCOMPARE(netInTable(), netOf(m_a));
        chord(Qt::Key_T);
        click(flat(), screenOf(flat(), m_b));
        QCOMPARE(netInTable(), netOf(m_a));
        chord(Qt::Key_T);

        const auto fit = [this] {
            flat().controller().fit();
            solid().controller().fit();
            return std::array{flat().controller().mmPerPixel(), solid().controller().mmPerPixel()};
        };
        const std::array<float, 2> fitted = fit();
        clickNet(m_b);
        QCOMPARE(window().selection().nets(), std::vector{boardNet(m_b)});
        QCOMPARE(flat().controller().mmPerPixel(), fitted[0]);
        chord(Qt::Key_V);
        clickNet(smallestNet());
        QVERIFY(flat().controller().mmPerPixel() < fitted[0] * 0.9F);
        QVERIFY(solid().controller().mmPerPixel() < fitted[1] * 0.9F);
        shoot("probe-from-table");
        chord(Qt::Key_V);
    }

    void theElementIsToldOfAndEscapeGoesBackStepByStep() {
        window().showPanel("element");
        click(flat(), screenOf(flat(), m_a));
        const model::BoardElement element = *window().selection().current();
        QCOMPARE(window().fact("Net"), QString::fromStdString(netOf(element.element)));
        QCOMPARE(window().fact("Layer"),
                 QString::fromStdString(board().layer(board().elements.layer[element.element.row()]).name));
        m_fixture->key(Qt::Key_N);
        m_fixture->key(Qt::Key_M);
        click(flat(), screenOf(flat(), m_a));
        shoot("element");
        m_fixture->key(Qt::Key_Escape);  // the measurement begun
        m_fixture->key(Qt::Key_Escape);  // measuring
        QVERIFY(!window().actions()[ActionId::MeasurePoints].isChecked());
        QCOMPARE(window().selection().nets(), std::vector{boardNet(m_a)});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().nets().empty());
    }

    void distancesAreMeasured() {
        window().showPanel("measurements");
        const std::size_t before = measurements().size();
        m_fixture->key(Qt::Key_M);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_b));
        QCOMPARE(measurements().size(), before + 1);
        const Measurement centres = measurements().back();
        QVERIFY2(std::abs(centres.distance() - m_inspected->centresMm * base::kNmPerMm) < kReadNm,
                 qPrintable(QString::number(centres.distance())));
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(solid(), screenOf(solid(), m_a));
        click(solid(), screenOf(solid(), m_b));
        QCOMPARE(measurements().size(), before + 2);
        const Measurement edges = measurements().back();
        QVERIFY(edges.kind == model::MeasurementKind::Clearance && edges.distance() > 0);
        QVERIFY2(std::abs(edges.distance() - m_inspected->edgesMm * base::kNmPerMm) < kReadNm,
                 qPrintable(QString::number(edges.distance())));
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        shoot("measured");
    }

    void narrowGapsAreSteppedThroughAndTheLensLightsNeighbours() {
        window().showPanel("clearances");
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::View));
        m_fixture->key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!window().workspace().isWorking());
        const auto& locations = window().find<ui::ClearanceModel>();
        QVERIFY2(locations.rowCount() > 0, qPrintable(label("summary")));
        for (int row = 0; row < std::min(locations.rowCount(), 3); ++row) {
            m_fixture->key(Qt::Key_F8);
            const model::RuleFinding& found = locations.location(row).found;
            QCOMPARE(panel().table().currentIndex().row(), row);
            const std::vector<model::BoardElement> sides{{0, std::min(found.a, found.b)},
                                                         {0, std::max(found.a, found.b)}};
            QCOMPARE(window().selection().selected(), sides);
        }
        shoot("clearance");
        window().selection().select({{0, m_a}});
        m_fixture->key(Qt::Key_L);
        lensSlider().setValue(lensSlider().maximum());
        QTRY_VERIFY(!window().selection().nearby().empty());
        shoot("lens");
        m_fixture->key(Qt::Key_L);
        QVERIFY(window().selection().nearby().empty());
    }

    void aJobThatKnowsAlmostNothingIsShownAndAsked() {
        const fs::path job = m_fixture->copyOfJob("everything");
        for (const char* part : {"steps/board/eda", "steps/board/layers/comp_+_top", "steps/board/layers/comp_+_bot",
                                 "misc/attrlist", "steps/board/layers/top/attrlist", "steps/board/layers/core1",
                                 "steps/board/layers/core2", "steps/board/layers/inner plane/attrlist"}) {
            QVERIFY2(fs::remove_all(job / part) > 0, part);
        }
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        QVERIFY(board().nets.empty() && board().components.empty());
        QVERIFY(std::ranges::all_of(board().stackup.rows, [](const model::StackupRow& row) {
            return row.source != model::Source::Job && row.thickness >= 0;
        }));
        window().selection().select({{0, model::ElementId{0}}});
        for (const Qt::Key key : {Qt::Key_N, Qt::Key_P, Qt::Key_L, Qt::Key_U, Qt::Key_R, Qt::Key_Z, Qt::Key_F8}) {
            m_fixture->key(key);
        }
        for (const Qt::Key key : {Qt::Key_N, Qt::Key_G}) {
            m_fixture->key(key, Qt::ControlModifier | Qt::ShiftModifier);
            QTRY_VERIFY(!isBusy());
        }
        m_fixture->key(Qt::Key_L);
        QVERIFY(window().selection().nets().empty());
        QVERIFY(!window().panel("netCheck").findChild<QLabel*>()->text().isEmpty());
        QVERIFY(!window().label("stackupSummary").isEmpty());
        QVERIFY(inkOf(m_fixture->picture()) > 0.01);
        shoot("almost-nothing");
    }

    void aNetWithoutCopperIsChosenAndNothingMoves() {
        const fs::path job = m_fixture->copyOfJob("open_short");
        std::ofstream(job / "steps/pcb/eda/data", std::ios::app) << "NET EMPTY\n";
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        const model::NetId empty = board().findNet("EMPTY");
        QVERIFY(empty.isValid() && board().elementsOf(empty).empty());
        QTRY_VERIFY(window().nets().isArranged());
        const float before = flat().controller().mmPerPixel();
        chord(Qt::Key_V);
        clickRow(*window().nets().rowOf(empty));
        QTest::keyClick(&nets(), Qt::Key_Return);
        chord(Qt::Key_V);
        QCOMPARE(window().selection().nets(), (std::vector<model::BoardNet>{{0, empty}}));
        QCOMPARE(flat().controller().mmPerPixel(), before);
        m_fixture->key(Qt::Key_L);
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Nets));
        m_fixture->key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!isBusy());
        QCOMPARE(window().find<ui::ClearanceModel>().rowCount(), 0);
        QVERIFY(window().selection().nearby().empty());
        m_fixture->key(Qt::Key_L);
    }

    void theSessionOfAnotherBoardIsToldAndNotUsed() {
        const fs::path job = m_fixture->copyOfJob("drills");
        std::ofstream(job.string() + ".copperscope.json")
            << R"({"copperscope_session": 1, "job": "elsewhere", "thickness_nm": {"L1": 5000}})";
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains("elsewhere"));
        QVERIFY(board().layer(board().findLayer("L1")).thickness != 5000);
    }

    void theSessionOfAnotherVersionIsToldAndKept() {
        const fs::path job = m_fixture->copyOfJob("negative");
        const std::string session = job.string() + ".copperscope.json";
        std::ofstream(session) << R"({"copperscope_session": 99, "job": "negative"})";
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(job.string())));
        QVERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("99"), qPrintable(window().error()));
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        window().awaitFiles();
        std::stringstream text;
        text << std::ifstream(session).rdbuf();
        QVERIFY(QString::fromStdString(text.str()).contains("99"));  // nothing is written over it
    }

    void aReloadWhileEverythingIsSearchedEndsTheSearch() {
        startSearches();
        const QSignalSpy started(&window().loader(), &ui::Loader::started);
        m_fixture->key(Qt::Key_F5);
        QCOMPARE(started.count(), 1);
        QTRY_VERIFY(!window().loader().isLoading());
        QVERIFY(!window().workspace().isWorking());
        QVERIFY(!window().workspace().isWorking());
        QTRY_VERIFY(!window().find<ui::Lens>().isSearching());  // about what stays selected
        QCOMPARE(window().find<ui::ClearanceModel>().rowCount(), 0);
        QCOMPARE(window().netCheck().rowCount(), 0);
    }

    void aWindowClosedWhileEverythingIsSearchedGoes() {
        startSearches();
        m_fixture->key(Qt::Key_F5);
        m_fixture->restart();
        QVERIFY(window().document() == nullptr);
        QVERIFY(!isBusy());
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    BoardView& flat() { return window().views().flat(); }
    BoardView& solid() { return window().views().solid(); }
    ui::StackupView& stackupView() { return window().stackupPanel().view(); }
    ui::TableView& nets() { return window().netsPanel().table(); }
    ClearancePanel& panel() { return window().find<ui::ClearancePanel>(); }
    QComboBox& box(const char* name) { return *panel().findChild<QComboBox*>(name); }
    QSlider& lensSlider() { return *panel().findChild<QSlider*>("lensReach"); }
    QString label(const char* name) { return panel().findChild<QLabel*>(name)->text(); }
    const model::Document& board() { return *window().document(); }
    const ui::BoardPosition& place() { return window().probing().position(); }
    const std::vector<Measurement>& measurements() { return window().measurements().measurements(); }
    bool isBusy() {
        return window().workspace().isWorking() || window().workspace().isWorking() ||
               window().find<ui::Lens>().isSearching();
    }

    void openJob() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        window().resize(1400, 900);
        m_name = board().job.name;
        m_a = padOf(m_inspected->netA);
        m_b = padOf(m_inspected->netB);
        QVERIFY(m_a.isValid() && m_b.isValid());
    }
    void startSearches() {
        box("where").setCurrentIndex(static_cast<int>(ClearancePanel::Where::Board));
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(&window().searchBox().line(), "gnd");
        QTest::keyClick(&window().searchBox().line(), Qt::Key_Escape);  // while it is open, keys are its own
        window().selection().select({{0, m_a}});
        window().actions()[ActionId::Lens].trigger();
        window().actions()[ActionId::SearchClearances].trigger();
        window().actions()[ActionId::CheckNets].trigger();
        QVERIFY(isBusy());
    }

    /// The largest round pad of a net on the uppermost copper.
    model::ElementId padOf(const char* net) {
        model::ElementId largest;
        for (const model::ElementId id : board().elementsOf(board().findNet(net))) {
            const model::Layer& layer = board().layer(board().elements.layer[id.row()]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top &&
                (board().elements.flags[id.row()] & model::kPad) != 0 &&
                board().elements.kind[id.row()] == model::ElementKind::Circle &&
                (!largest.isValid() || circleOf(id).diameter > circleOf(largest).diameter)) {
                largest = id;
            }
        }
        return largest;
    }
    const model::CircleGeometry& circleOf(model::ElementId id) {
        return board().circles[board().elements.geometry[id.row()]];
    }
    std::string netOf(model::ElementId id) { return board().nets[board().elements.net[id.row()].row()].name; }
    model::BoardNet boardNet(model::ElementId id) { return {0, board().elements.net[id.row()]}; }
    std::string netSelected() {
        const auto current = window().selection().current();
        return current ? netOf(current->element) : std::string();
    }
    std::string netInTable() {
        const QModelIndex at = nets().currentIndex();
        return at.isValid() ? board().nets[window().nets().netAt(at.row()).row()].name : std::string();
    }
    /// An element of the net of the least extent.
    model::ElementId smallestNet() {
        model::ElementId smallest;
        std::int64_t least = std::numeric_limits<std::int64_t>::max();
        for (std::size_t row = 0; row < board().nets.size(); ++row) {
            model::Box box;
            for (const model::ElementId element : board().elementsOf(model::NetId{row})) {
                box.include(board().boxOf(element));
            }
            if (!box.isEmpty() && box.width() + box.height() < least) {
                least = box.width() + box.height();
                smallest = board().elementsOf(model::NetId{row}).front();
            }
        }
        return smallest;
    }
    double heightOf(model::ElementId id) {
        const model::Layer& layer = board().layer(board().elements.layer[id.row()]);
        return double(layer.z + layer.thickness);
    }
    QPointF screenOf(BoardView& view, model::ElementId id) {
        const auto at = view.controller().screenOf(place().toModel(base::toDouble(circleOf(id).centre), heightOf(id)));
        return at.value_or(QPointF(-1, -1));
    }
    std::vector<std::size_t> rowsWithLayers() {
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < board().stackup.rows.size(); ++row) {
            if (board().stackup.rows[row].layer.isValid()) {
                rows.push_back(row);
            }
        }
        return rows;
    }
    void clickBand(std::size_t row, Qt::KeyboardModifiers modifiers = {}) {
        const QRectF band = stackupView().bandRect(row);
        QTest::mouseClick(&stackupView(), Qt::LeftButton, modifiers,
                          QPointF(band.left() + 2.0, band.center().y()).toPoint());
    }
    void clickNet(model::ElementId id) { clickRow(*window().nets().rowOf(board().elements.net[id.row()])); }
    void clickRow(int row) {
        const QModelIndex at = window().nets().index(row, 0);
        nets().scrollTo(at);
        QTest::mouseClick(nets().viewport(), Qt::LeftButton, {}, nets().visualRect(at).center());
    }
    /// Ctrl+K and a key after it.
    void chord(Qt::Key key) {
        m_fixture->key(Qt::Key_K, Qt::ControlModifier);
        m_fixture->key(key);
    }
    /// Types the thickness of a row of the stack.
    void type(int row, const QString& text) {
        QTableView& table = window().stackupPanel().table();
        const QModelIndex at = table.model()->index(row, StackupModel::Thickness);
        table.scrollTo(at);
        table.setFocus();
        table.setCurrentIndex(at);
        QTest::keyClick(&table, Qt::Key_F2);
        auto* editor = table.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(table.viewport()->findChild<QLineEdit*>() == nullptr);
    }
    /// Writes what is on the screen where the window is, for people to look at.
    void shoot(const char* name) {
        const QString folder = qEnvironmentVariable("COPPERSCOPE_SHOTS");
        if (folder.isEmpty()) {
            return;
        }
        QTest::qWait(800);  // slow views draw themselves finely once they rest
        const QRect at(window().mapToGlobal(QPoint(0, 0)), window().size());
        const bool isOnScreen = m_fixture->context().surfaceInstance() != nullptr;
        const QPixmap shot =
            isOnScreen ? QGuiApplication::primaryScreen()->grabWindow(0, at.x(), at.y(), at.width(), at.height())
                       : window().grab();
        QVERIFY(shot.save(QStringLiteral("%1/%2.png").arg(folder, QLatin1String(name))));
    }

    std::unique_ptr<WindowFixture> m_fixture;
    const Inspected* m_inspected = nullptr;
    fs::path m_job;
    std::string m_name;
    model::ElementId m_a;
    model::ElementId m_b;
};

QTEST_MAIN(InspectionTest)
#include "inspection_test.moc"
