#include "ui/section/section_feature.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QRegularExpression>
#include <QStatusBar>
#include <QWheelEvent>
#include <QtTest>
#include <set>

#include "model/base/thickness_units.h"
#include "model/export/section_export.h"
#include "model/section/intervals.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/section/section_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/thickness_text.h"
#include "ui/shell/message_bar.h"

using model::SectionPiece;
using ui::ActionId;
using ui::BoardView;

/// The cut in its panel, and what is kept and exported of it, on the sample board.
class SectionFeatureTest : public QObject, protected SectionFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void init() { reset(); }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    /// Layers of the sample draw beyond its outline.
    void whatIsMilledAwayIsShownByACommandOnly() {
        const auto& milled = window().workspace().board()->model->milled;
        const auto isCopper = [&](model::ElementId element) {
            return m_index->board->layer(m_index->board->elements.layer[element.row()]).isCopper();
        };
        const auto element = std::ranges::find_if(milled, isCopper);
        QVERIFY(element != milled.end());
        const model::Box box = m_index->board->boxOf(*element);
        const double x = static_cast<double>(box.middle().x);
        sections().cutAlong({{x, box.min.y - 1e6}, {x, box.max.y + 1e6}});
        const auto isMet = [&] {
            return std::ranges::any_of(view().section()->pieces,
                                       [&](const SectionPiece& piece) { return piece.at.element == *element; });
        };
        QVERIFY(!isMet());
        QVERIFY(std::ranges::any_of(view().section()->notes, [](const std::string& note) {
            return note.starts_with("left out as milled away beyond the board outline");
        }));
        window().actions()[ActionId::ShowMilledAway].trigger();
        QVERIFY(isMet());
        window().actions()[ActionId::ShowMilledAway].trigger();
        QVERIFY(!isMet());
    }

    void aPieceIsFoundToldAndSelectedWhereItIsDrawn() {
        drawLine();
        const SectionPiece piece = aCopperPiece();
        const QPointF at = view().positionOf((piece.from + piece.to) / 2, (double{1} * piece.bottom + piece.top) / 2);
        QVERIFY(view().pieceAt(at) != nullptr);
        QVERIFY(view().pieceAt(at)->at == piece.at);
        QVERIFY(view().tipAt(at).startsWith(QString::fromStdString(m_index->board->layer(piece.layer).name)));
        QVERIFY(view().tipAt(at).contains(QString::fromStdString(model::netOf(*m_index, piece))));
        const QImage before = view().grab().toImage();
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at.toPoint());
        QCOMPARE(window().selection().selected(), std::vector{piece.at});
        QVERIFY(differingPixels(before, view().grab().toImage()) > 5);
        QVERIFY(view().pieceAt({2, 2}) == nullptr);
        QVERIFY(view().tipAt({2, 2}).isEmpty());
    }

    void aBodyIsNamedByItsComponentAndSelectedByTheMenu() {
        const auto [piece, name] = aBodyInSight();
        QVERIFY2(!name.isEmpty(), "no body is met");
        const QPointF at = lowIn(piece);
        QVERIFY2(view().tipAt(at).section('\n', 0, 0).endsWith(" · " + name), qPrintable(view().tipAt(at)));
        QTest::mouseClick(&view(), Qt::RightButton, {}, at.toPoint());
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu != nullptr);
        QVERIFY(menu->actions().contains(&window().actions()[ActionId::SaveSection]));
        QVERIFY(menu->actions().contains(&window().actions()[ActionId::ExportSection]));
        auto* select = menu->findChild<QAction*>("select");
        QVERIFY2(select != nullptr && select->text().endsWith(' ' + name), "it says what it selects");
        select->trigger();
        QCOMPARE(window().selection().selected(), std::vector{piece.at});
        menu->close();
        window().activateWindow();  // the offscreen platform does not give it back
        (void)QTest::qWaitForWindowActive(&window());
    }

    void theWheelZoomsToTheCursorADragPansAndADoubleClickShowsAll() {
        drawLine();
        const QPointF whole = view().positionOf(1e6, 0);
        const double times = view().heightTimes();
        QWheelEvent wheel(whole, view().mapToGlobal(whole), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view(), &wheel);
        QVERIFY(QLineF(whole, view().positionOf(1e6, 0)).length() < 1e-6);
        QVERIFY(QLineF(whole, view().positionOf(2e6, 0)).length() > 0);
        QCOMPARE(view().heightTimes(), times);
        QTest::mousePress(&view(), Qt::LeftButton, {}, {100, 60});
        QTest::mouseMove(&view(), {130, 70});
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, {130, 70});
        QVERIFY(QLineF(whole + QPointF(30, 10), view().positionOf(1e6, 0)).length() < 1e-6);
        QVERIFY(window().selection().selected().empty());
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, {100, 60});
        QVERIFY(QLineF(whole, view().positionOf(1e6, 0)).length() < 1e-6);
    }

    void aDoubleClickKeepsWhatItsFirstClickSelected() {
        drawLine();
        const SectionPiece piece = aCopperPiece();
        const QPointF fitted =
            view().positionOf((piece.from + piece.to) / 2, (double{1} * piece.bottom + piece.top) / 2);
        const QPoint from(100, 60);
        const QPoint by(0, fitted.y() < view().height() / 2.0 ? 25 : -25);
        QTest::mousePress(&view(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&view(), from + by);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + by);
        const QPoint at = fitted.toPoint() + by;
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at);
        QCOMPARE(window().selection().selected(), std::vector{piece.at});
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, at);
        const SectionPiece* under = view().pieceAt(at);  // now that all is shown again
        QVERIFY(under == nullptr || under->at != piece.at);
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, at);
        QCOMPARE(window().selection().selected(), std::vector{piece.at});
    }

    void heightsAreDrawnAsManyTimesLargerAsAskedFor() {
        drawLine();
        for (int row = 1; row < window().find<ui::SectionPanel>().heightsBox().count(); ++row) {
            window().find<ui::SectionPanel>().heightsBox().setCurrentIndex(row);
            const QPointF zero = view().positionOf(0, 0);
            const double perLength = view().positionOf(1e6, 0).x() - zero.x();
            const double perHeight = zero.y() - view().positionOf(0, 1e6).y();
            QVERIFY(std::abs(perHeight / perLength -
                             window().find<ui::SectionPanel>().heightsBox().currentData().toDouble()) < 1e-6);
        }
    }

    void theBoardOf3dIsCutOpenAlongTheLineAndFollowsIt() {
        window().actions()[ActionId::OpenAlongSection].trigger();
        QVERIFY(window().views().solid().cut() == nullptr);  // no line
        drawLine();
        window().actions()[ActionId::OpenAlongSection].trigger();
        QVERIFY(window().actions()[ActionId::SectionPlane].isChecked());
        const auto along = [&] { return window().views().solid().cut()->plane.direction; };
        QVERIFY(std::abs(along().x + 1.0) < 1e-6);  // from its end to its start: seen as in the panel
        const auto [from, to] = acrossBoard();
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, from + QPointF(1, -60));
        mouse(QEvent::MouseButtonRelease, from + QPointF(1, -60));
        QTRY_VERIFY(std::abs(along().y + 1.0) < 0.01);
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY(window().views().solid().cut() == nullptr);
    }

    void theKeysOfThePlaneAreSaidWhileThereIsOne() {
        const auto said = [&] { return window().statusBar()->currentMessage(); };
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY2(said().contains("\"Shift+X\" rotates it"), qPrintable(said()));
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY(said().isEmpty());
        for (const ActionId id :
             {ActionId::MoveSectionPlaneOn, ActionId::MoveSectionPlaneBack, ActionId::RotateSectionPlane}) {
            window().workspace().report(QString());
            window().actions()[id].trigger();
            QCOMPARE(said(), QStringLiteral("There is no section plane: \"X\" makes one"));
        }
    }

    void besideTheBoardThePlaneGoesThroughItsMiddle() {
        const model::Box& board = m_index->board->board;
        const auto heightOf = [&](double part) {
            const double y = board.min.y + part * static_cast<double>(board.height());
            const base::PointD at{(double{1} * board.min.x + board.max.x) / 2, y};
            mouse(QEvent::MouseMove, *flat().controller().screenOf(window().probing().position().toModel(at)));
            window().actions()[ActionId::SectionPlane].trigger();
            const double cut = window().views().solid().cut()->plane.start.y;
            window().actions()[ActionId::SectionPlane].trigger();
            return cut;
        };
        const double middle = heightOf(0.5);
        QVERIFY(std::abs(heightOf(0.25) - middle) > 1.0);
        QVERIFY(std::abs(heightOf(1.05) - middle) < 0.01);
        QVERIFY(std::abs(heightOf(-0.05) - middle) < 0.01);
    }

    void wherePartOfTheBoardIsSeenThePlaneAndItsArrowAreInSight() {
        ui::CameraController& camera = window().views().solid().controller();
        camera.look(render::NamedView::Top);
        const render::CameraPose pose = camera.camera().pose();
        const QRectF canvas({}, camera.viewport());
        const auto& handle = window().find<ui::SectionHandle>();
        const auto inSight = [&] { return handle.place() && canvas.contains(*handle.place()); };
        camera.zoomAt(canvas.center() + QPointF(canvas.width() * 0.3, 0.0), 8.0F);
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY(inSight());
        const render::SectionPlane seen = window().views().solid().cut()->plane;
        camera.setPose(pose);
        QVERIFY(inSight());
        camera.zoomAt(canvas.center() + QPointF(-canvas.width() * 0.3, 0.0), 8.0F);  // it runs along x
        QVERIFY(inSight());
        QCOMPARE(window().views().solid().cut()->plane.start, seen.start);
        window().actions()[ActionId::SectionPlane].trigger();
        camera.setPose(pose);
    }

    void thePlaneIsDraggedByItsArrowAndStaysOnTheBoard() {
        window().views().setArrangement(ui::Arrangement::Solid);
        window().views().solid().controller().look(render::NamedView::Iso);
        window().actions()[ActionId::SectionPlane].trigger();
        const auto& handle = window().find<ui::SectionHandle>();
        const auto cut = [&] { return window().views().solid().cut()->plane; };
        const render::SectionPlane before = cut();
        const QPointF from = handle.place().value();
        const render::CameraPose pose = window().views().solid().controller().camera().pose();
        mouseIn3D(QEvent::MouseButtonPress, from);
        mouseIn3D(QEvent::MouseMove, from + QPointF(12, -7));
        const render::SectionPlane moved = cut();
        QCOMPARE(moved.direction, before.direction);
        const glm::dvec2 way = moved.start - before.start;
        QVERIFY(std::abs(glm::dot(way, before.direction)) < 0.1 * glm::length(way) + 1.0);
        const QPointF now = handle.place().value() - from;
        QVERIFY(QPointF::dotProduct(now, now) > 1.0);
        QVERIFY(std::abs(QPointF::dotProduct(QPointF(12, -7) - now, now)) < 0.2 * QPointF::dotProduct(now, now));
        mouseIn3D(QEvent::MouseMove, from + QPointF(12'000, -7'000));
        const model::Box& board = m_index->board->board;
        const double y = cut().start.y * 1e6 + double(window().workspace().board()->model->origin.y);
        QVERIFY(y >= double(board.min.y) - 1.0 && y <= double(board.max.y) + 1.0);
        mouseIn3D(QEvent::MouseButtonRelease, from + QPointF(12'000, -7'000));
        QVERIFY(window().views().solid().controller().camera().pose() == pose);  // the board was not turned
        mouseIn3D(QEvent::MouseButtonPress, handle.place().value());
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY(!handle.place());
        mouseIn3D(QEvent::MouseMove, from);
        mouseIn3D(QEvent::MouseButtonRelease, from);
        QVERIFY(window().views().solid().cut() == nullptr);
        window().views().setArrangement(ui::Arrangement::SideBySide);
    }

    void otherHeightsAreCutAtOnce() {
        drawLine();
        const SectionPiece piece = aCopperPiece();
        auto thicker = std::make_shared<model::Document>(*m_index->board);
        thicker->layers[piece.layer.row()].thickness += 70'000;
        window().workspace().restack(thicker, {}, true);
        const auto now = std::ranges::find(view().section()->pieces, piece.at, &SectionPiece::at);
        QVERIFY(now != view().section()->pieces.end());
        QCOMPARE(now->top - now->bottom, piece.top - piece.bottom + 70'000);
        window().workspace().restack(m_index->board, {}, true);
    }

    void theSectionIsExported() {
        const QString path = m_fixture->folder() + "/cut.svg";
        QVERIFY(!sections().drawing(path));  // nothing to export
        window().actions()[ActionId::ExportSection].trigger();
        QVERIFY(window().findChild<QFileDialog*>() == nullptr);
        QCOMPARE(window().statusBar()->currentMessage(),
                 QStringLiteral("There is no section to export: draw one first"));
        drawLine();
        window().save(ActionId::ExportSection, path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        QVERIFY(svg.startsWith("<svg"));
        const auto count = static_cast<qsizetype>(model::merged(view().section()->pieces).size());
        qsizetype contours = 0;
        const QRegularExpression fill("<path d=\"([^\"]*)\" fill=\"#(?!000000|ffffff)");
        for (const auto& match : fill.globalMatch(QString::fromUtf8(svg))) {
            contours += match.captured(1).count('M');
        }
        qsizetype swatches = 0;
        for (const auto& [colours, name] : view().legend()) {
            swatches += qsizetype(colours.size());
        }
        // All but print and parts lies on what has the colour of its first dielectric.
        qsizetype under = 0;
        for (const SectionPiece& piece : model::merged(view().section()->pieces)) {
            const int order = model::drawOrderOf(piece.material);
            const bool isPrinted =
                piece.material == model::SectionMaterial::Silkscreen || piece.material == model::SectionMaterial::Paste;
            under += (order == 0 || order == 3) && !isPrinted ? 1 : 0;
        }
        QCOMPARE(contours, count + swatches + under);
        window().save(ActionId::ExportSection, "/nowhere/cut.svg");
        QVERIFY2(window().error().startsWith("/nowhere/cut.svg cannot be written"), qPrintable(window().error()));
        const std::string pdf = *sections().drawing("cut.pdf");
        const QRegularExpressionMatch size = QRegularExpression("width=\"([0-9.]+)mm\"").match(svg);
        const QRegularExpressionMatch page = QRegularExpression("/MediaBox \\[0 0 ([0-9.]+) ")
                                                 .match(QString::fromLatin1(QByteArray::fromStdString(pdf)));
        QVERIFY(size.hasMatch() && page.hasMatch());
        const double pointsPerMm = 72.0 / 25.4;
        QVERIFY(std::abs(size.captured(1).toDouble() * pointsPerMm - page.captured(1).toDouble()) < 1.0);
    }

    void theSheetOfAnUnrolledNetNamesIt() {
        for (std::size_t row = 0; row < m_index->board->nets.size() && !view().section(); ++row) {
            window().selection().setNets({{0, model::NetId{row}}});
            window().actions()[ActionId::SectionAlongNet].trigger();
        }
        const auto text = [&] { return QString::fromStdString(*sections().drawing("net.svg")); };
        const auto nets = window().selection().nets();
        const QString name = QString::fromStdString(m_index->board->nets[nets.front().net.row()].name);
        QVERIFY(text().contains("section along net " + name.toHtmlEscaped() + ","));
        drawLine();
        QVERIFY(text().contains("section from ") && !text().contains("along net"));
        window().selection().setNets({});
    }

    /// Parts are often many times as high as a board.
    void allOfTheSectionIsInSightAndNamesPointToIt() {
        drawLine();
        model::Section section = *view().section();
        std::erase_if(section.pieces, [](const SectionPiece& piece) {
            return piece.material == model::SectionMaterial::Part || piece.material == model::SectionMaterial::Terminal;
        });
        SectionPiece part;
        part.layer = section.pieces.front().layer;
        part.at = section.pieces.front().at;
        part.from = 1e6;
        part.to = 3e6;
        part.bottom = m_index->board->boardThickness;
        part.top = 2 * part.bottom;
        part.material = model::SectionMaterial::Part;
        section.pieces.push_back(part);
        view().setSection(m_index, section);
        view().fit();
        QVERIFY(view().positionOf(0, double(part.top)).y() > 0.0);
        QVERIFY(view().positionOf(0, 0.0).y() < view().height());
        QVERIFY(view().brokenParts().empty());
        section.pieces.back().top = 40 * part.bottom;  // the board would be a thin line
        view().setSection(m_index, section);
        QCOMPARE(view().brokenParts().size(), std::size_t{1});
        const QImage broken = view().grab().toImage();
        const double bottom = view().positionOf(0, 0.0).y();
        QVERIFY(bottom < view().height() && bottom - view().positionOf(0, double(part.bottom)).y() > 20.0);
        section.pieces.back().top = 2 * part.bottom;
        view().setSection(m_index, section);
        QVERIFY(differingPixels(broken, view().grab().toImage()) > 100);
        const std::vector<SectionPiece> drawn = model::merged(section.pieces);
        int marked = 0;
        for (std::size_t row = 0; row < m_index->board->stackup.rows.size(); ++row) {
            const model::LayerId layer = m_index->board->stackup.rows[row].layer;
            if (!layer.isValid() || !m_index->board->layer(layer).isCopper()) {
                continue;
            }
            double end = -1.0;
            for (const SectionPiece& piece : drawn) {
                end = piece.layer == layer ? std::max(end, piece.most()) : end;
            }
            const std::optional<QPointF> mark = view().markOf(row);
            QCOMPARE(mark.has_value(), end >= 0.0);
            if (mark) {
                ++marked;
                QVERIFY(std::abs(mark->x() - view().positionOf(end, 0.0).x()) < 1e-6);
            }
        }
        QVERIFY(marked > 3);
    }

    void aDielectricSaysHowHighItIsHereAndHowThickItIs() {
        drawLine();
        int beside = 0;
        int between = 0;
        for (const SectionPiece& piece : view().section()->pieces) {
            const model::StackupRow* row = model::stackupRowOf(*m_index->board, piece);
            if (row == nullptr || piece.leans() || piece.to - piece.from < 1e5) {
                continue;
            }
            const QString tip = view().tipAt(
                view().positionOf((piece.from + piece.to) / 2, (double{1} * piece.bottom + piece.top) / 2));
            if (!tip.startsWith(QString::fromStdString(row->name) + " · ")) {
                continue;  // a part of it is too small for the pointer
            }
            const QString thickness = ui::thicknessText(row->thickness, view().unit()) + " thick in the stackup";
            QVERIFY2(tip.contains(thickness), qPrintable(tip));
            const bool isHigher = piece.top - piece.bottom > row->thickness;
            QCOMPARE(tip.contains("fills the space beside copper here"), isHigher);
            ++(isHigher ? beside : between);
        }
        QVERIFY2(beside > 0 && between > 0, qPrintable(QString("%1 %2").arg(beside).arg(between)));
    }

    void anEmptyViewStaysWhereItIsAndANewLineIsShownWhole() {
        view().resize(600, 260);
        const auto drag = [this] {
            QTest::mousePress(&view(), Qt::LeftButton, {}, {100, 60});
            QTest::mouseMove(&view(), {180, 90});
            QTest::mouseRelease(&view(), Qt::LeftButton, {}, {180, 90});
        };
        const auto zoom = [this] {
            QWheelEvent wheel({100, 60}, view().mapToGlobal(QPointF(100, 60)), {}, {0, 480}, Qt::NoButton, {},
                              Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(&view(), &wheel);
        };
        const auto ends = [this] {
            return QLineF(view().positionOf(0, 0), view().positionOf(view().section()->stations.back(), 0));
        };
        const auto isWhole = [&] {
            const QLineF now = ends();
            view().fit();
            return now == ends();
        };
        drag();
        zoom();
        drawLine();
        QVERIFY(isWhole());
        drag();
        zoom();
        QVERIFY(!isWhole());
        zoom();
        drawLine();  // another one, though it lies where the first one did
        QVERIFY(isWhole());
        zoom();
        const QLineF before(view().positionOf(0, 0), view().positionOf(1e6, 0));
        const auto [from, to] = acrossBoard();
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, to + QPointF(-40, 17));
        mouse(QEvent::MouseButtonRelease, to + QPointF(-40, 17));
        QCOMPARE(QLineF(view().positionOf(0, 0), view().positionOf(1e6, 0)), before);
    }

    /// Rows that are not alike must not read alike; names stay before figures do, and have what room there is.
    void namesBesideASectionTellItsRowsApart() {
        drawLine();
        std::set<QString> names;
        for (const model::StackupRow& row : window().document()->stackup.rows) {
            names.insert(QString::fromStdString(row.name));
        }
        for (const int width : {220, 300, 400, 600, 900, 1400}) {
            view().resize(width, 400);
            const auto labels = view().labels();
            QVERIFY(labels.size() > 2);
            std::set<QString> told;
            for (const auto& label : labels) {
                QVERIFY2(label[0].size() > 2, qPrintable(QString("%1 at %2").arg(label[0]).arg(width)));
                told.insert(label[0]);
                QVERIFY(width < 900 || names.contains(label[0]));
                QVERIFY(width < 600 || (!label[1].isEmpty() && !label[2].isEmpty()));
            }
            QCOMPARE(told.size(), labels.size());
        }
    }

    void numbersBesideASectionAreWholeAndItsRowsInTheirOrder() {
        drawLine();
        QTRY_VERIFY(view().section().has_value());
        view().resize(600, 260);
        const auto& rows = window().document()->stackup.rows;
        const auto isOf = [](const ui::SectionView::LabelTexts& label, const model::StackupRow& row) {
            const QString name = QString::fromStdString(row.name);
            return label[1] == QString::fromStdString(model::thicknessText(row.thickness)) &&
                   name.startsWith(label[0].section(QChar(0x2026), 0, 0)) &&
                   name.endsWith(label[0].section(QChar(0x2026), -1));
        };
        const auto labels = view().labels();
        QVERIFY(labels.size() > 2);
        auto row = rows.begin();
        for (const auto& label : labels) {
            row = std::find_if(row, rows.end(), [&](const model::StackupRow& of) { return isOf(label, of); });
            QVERIFY2(row != rows.end(), qPrintable(label[0] + ' ' + label[1]));
            QVERIFY(label[2].startsWith("at ") && label[2].endsWith(" mm") && !label[2].contains(QChar(0x2026)));
            ++row;
        }
    }

    /// Its films are of no element: they are described and highlighted by nothing.
    void filmsOfARigidFlexBoardAreDescribed() {
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        sections().cutAlong({{0.0, 10e6}, {100e6, 10e6}});
        const auto& pieces = view().section()->pieces;
        const auto plate = std::ranges::find(pieces, model::SectionMaterial::Stiffener, &SectionPiece::material);
        QVERIFY(plate != pieces.end());
        const QPointF at =
            view().positionOf((plate->from + plate->to) / 2, (double{1} * plate->bottom + plate->top) / 2);
        QVERIFY2(view().tipAt(at).startsWith("PLATE · stiffener"), qPrintable(view().tipAt(at)));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, at.toPoint());
        QVERIFY(window().selection().selected().empty());
        QVERIFY(!view().grab().isNull());
        QVERIFY(m_fixture->openAndWait(m_board));
    }

    /// Its copper, or a hole in it, is all along the line; and no stroke is longer.
    void aNetIsFollowedOverItsLongestChain() {
        window().actions()[ActionId::SectionAlongNet].trigger();
        QVERIFY(!view().section());  // no net
        int followed = 0;
        for (std::size_t row = 0; row < m_index->board->nets.size(); ++row) {
            const model::NetId net{row};
            double longest = 0.0;
            for (const model::ElementId element : m_index->board->elementsOf(net)) {
                if (m_index->board->elements.kind[element.row()] == model::ElementKind::Line) {
                    const model::Box box = m_index->board->boxOf(element);
                    longest = std::max(
                        longest, double(std::max(box.width(), box.height()) - std::min(box.width(), box.height())));
                }
            }
            window().selection().setNets({{0, net}});
            sections().cutAlong({});
            window().actions()[ActionId::SectionAlongNet].trigger();
            if (!view().section()) {
                QCOMPARE(longest, 0.0);
                continue;
            }
            ++followed;
            const double length = view().section()->stations.back();
            QVERIFY(length >= longest / 1.5);
            model::Intervals copper;
            for (const SectionPiece& piece : view().section()->pieces) {
                if (m_index->board->elements.net[piece.at.element.row()] == net) {
                    copper.push_back({piece.from, piece.to});
                }
            }
            for (const SectionPiece& bore : view().section()->bores) {
                copper.push_back({bore.from, bore.to});
            }
            double covered = 0.0;
            for (const model::Interval& interval : model::united(copper)) {
                covered += interval.to - interval.from;
            }
            QVERIFY(covered > length - 1.0);
        }
        QVERIFY(followed > 3);
        window().selection().setNets({});
    }

    void anotherBoardForgetsTheLine() {
        drawLine();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/rigid_flex")));
        QVERIFY(!view().section());
        QVERIFY(window().find<ui::SectionLine>().line().empty());
        QVERIFY(m_fixture->openAndWait(m_board));
        QVERIFY(window().find<ui::SectionLine>().line().empty());
    }

private:
    void mouseIn3D(QEvent::Type type, QPointF at) {
        ui::BoardView& solid = window().views().solid();
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, solid.mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&solid.canvas(), &event);
    }
    /// Near the board, which is in sight where the part is not whole.
    [[nodiscard]] QPointF lowIn(const SectionPiece& piece) {
        constexpr double kAbove = 50'000.0;
        return view().positionOf((piece.from + piece.to) / 2, piece.bottom + kAbove);
    }
    /// Cuts through it; with the name of its component, empty for no such body.
    [[nodiscard]] std::pair<SectionPiece, QString> aBodyInSight() {
        for (const model::Body& body : m_index->board->bodies) {
            const model::Box box = m_index->board->boxOf(body.element);
            const double y = static_cast<double>(box.middle().y);
            sections().cutAlong({{box.min.x - 1e6, y}, {box.max.x + 1e6, y}});
            for (const SectionPiece& piece : view().section()->pieces) {
                const SectionPiece* seen = piece.at.element == body.element ? view().pieceAt(lowIn(piece)) : nullptr;
                if (seen != nullptr && seen->at == piece.at) {
                    const auto& components = m_index->board->components;
                    return {piece, QString::fromStdString(components[body.component.row()].refdes)};
                }
            }
        }
        return {};
    }
    [[nodiscard]] SectionPiece aCopperPiece() {
        const SectionPiece* widest = nullptr;
        for (const SectionPiece& piece : view().section()->pieces) {
            const bool isCopper = m_index->board->layer(piece.layer).isCopper();
            if (isCopper && (widest == nullptr || piece.to - piece.from > widest->to - widest->from)) {
                widest = &piece;
            }
        }
        return *widest;
    }
};

QTEST_MAIN(SectionFeatureTest)
#include "section_feature_test.moc"
