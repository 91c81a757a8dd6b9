#include "ui/section/section_feature.h"

#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QListView>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QStatusBar>
#include <QWheelEvent>
#include <QtTest>

#include "model/base/thickness_units.h"
#include "model/export/section_export.h"
#include "model/section/intervals.h"
#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/shell/message_bar.h"

using base::PointD;
using model::Nm;
using model::SectionPiece;
using ui::ActionId;
using ui::BoardView;

/// From the line in the 2D view to the cut in the panel, with real mouse events on the sample board.
class SectionFeatureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        m_board = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(m_board));
        base::Progress progress;
        const auto board = std::make_shared<const model::Document>(*window().document());
        m_index = *model::indexBoard(board, progress);
    }
    void init() {
        sections().cutAlong({});
        window().selection().select({});
        flat().controller().look(render::NamedView::Top);
        window().find<ui::SectionPanel>().heightsBox().setCurrentIndex(0);
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aDraggedLineIsCutLiveAndExactly() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(window().find<ui::SectionPanel>().isVisible());
        const auto [from, to] = acrossBoard();
        mouse(QEvent::MouseButtonPress, from);
        std::size_t last = 0;
        for (int step = 1; step <= 4; ++step) {
            mouse(QEvent::MouseMove, from + (to - from) * step / 4.0);
            QTRY_VERIFY(view().section() &&
                        isAt(view().section()->line.back(), window().find<ui::SectionLine>().line().back()));
            QCOMPARE(view().section()->pieces.size(), expected().pieces.size());
            QVERIFY(view().section()->pieces.size() > last);
            last = view().section()->pieces.size();
        }
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(same(view().section()->pieces, expected().pieces));
        QVERIFY(same(view().section()->bores, expected().bores));
        QVERIFY(window().selection().selected().empty());  // the drag drew no box
    }

    void theHintGoesWithTheTool() {
        QStatusBar& bar = *window().statusBar();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(bar.currentMessage().startsWith("Drag a line"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(bar.currentMessage().isEmpty());
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        window().workspace().report(QString("something else"));
        m_fixture->key(Qt::Key_Escape);
        QCOMPARE(bar.currentMessage(), QString("something else"));
        m_fixture->key(Qt::Key_M);
        QVERIFY(!bar.currentMessage().isEmpty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(bar.currentMessage().isEmpty());
    }

    void cornersAreClickedTakenBackAndEnded() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        const QPointF way = to - from;
        const std::vector<QPointF> clicks{from, from + way * 0.4, from + way * 0.4 + QPointF(0, 40), from + way * 0.8};
        for (const QPointF& at : clicks) {
            clickOn(at);
        }
        hover(to);
        QCOMPARE(window().find<ui::SectionLine>().line().size(), clicks.size() + 1);  // the last leg follows the cursor
        QTRY_VERIFY(view().section() && view().section()->line.size() == clicks.size() + 1);
        QVERIFY(same(view().section()->pieces, expected().pieces));
        pressKey(Qt::Key_Backspace);
        QCOMPARE(window().find<ui::SectionLine>().line().size(), clicks.size());
        clickOn(to);
        QVERIFY(window().actions()[ActionId::DrawSection].isChecked());
        pressKey(Qt::Key_Return);
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        const std::vector<PointD>& line = window().find<ui::SectionLine>().line();
        QCOMPARE(line.size(), std::size_t{4});
        const std::vector<QPointF> corners{clicks[0], clicks[1], clicks[2], to};
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto at = flat().controller().screenOf(window().probing().position().toModel(line[i]));
            QVERIFY(at && QLineF(*at, corners[i]).length() < 0.01);
        }
        QVERIFY(same(view().section()->pieces, expected().pieces));
        QVERIFY(window().selection().selected().empty());
    }

    /// Enter zooms in KLayout.
    void keysOfALineAreNoCommandsMeanwhile() {
        window().actions()[ActionId::KeysKLayout].trigger();
        window().actions()[ActionId::DrawSection].trigger();
        const auto [from, to] = acrossBoard();
        clickOn(from);
        clickOn(to);
        const float before = flat().controller().mmPerPixel();
        const auto typeEnter = [this] {
            if (auto* native = qobject_cast<QWindow*>(&flat().canvas())) {
                QTest::keyClick(native, Qt::Key_Return);
            } else {
                QTest::keyClick(qobject_cast<QWidget*>(&flat().canvas()), Qt::Key_Return);
            }
        };
        typeEnter();
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), std::size_t{2});
        QCOMPARE(flat().controller().mmPerPixel(), before);
        typeEnter();
        QVERIFY(flat().controller().mmPerPixel() < before);
    }

    void aDoubleClickEndsALineOfClicksAndShiftKeepsItsLegsStraight() {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        clickOn(from);
        mouse(QEvent::MouseButtonPress, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonRelease, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonDblClick, to + QPointF(0, 9), Qt::ShiftModifier);
        mouse(QEvent::MouseButtonRelease, to + QPointF(0, 9), Qt::ShiftModifier);
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), std::size_t{2});
        QCOMPARE(window().find<ui::SectionLine>().line()[0].y, window().find<ui::SectionLine>().line()[1].y);
        QVERIFY(view().section().has_value());
    }

    void drawingIsGivenUpAndTheLineIsWhatItWas() {
        drawLine();
        const std::vector<PointD> before = window().find<ui::SectionLine>().line();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        const auto [from, to] = acrossBoard();
        clickOn(from + QPointF(0, 25));
        pressKey(Qt::Key_Return);  // one corner is no line
        QVERIFY(window().find<ui::SectionLine>().isDrawing());
        QTRY_VERIFY(!view().section() && window().find<ui::SectionPanel>().notes().isEmpty());
        clickOn(to + QPointF(0, 25));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().find<ui::SectionLine>().isDrawing());
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QCOMPARE(window().find<ui::SectionLine>().line().size(), before.size());
        QVERIFY(isAt(window().find<ui::SectionLine>().line().back(), before.back()));
        QVERIFY(same(view().section()->pieces, expected().pieces));
    }

    void anEndIsMovedAndShiftKeepsTheLineStraight() {
        const auto [from, to] = acrossBoard();
        drawLine();
        const PointD start = window().find<ui::SectionLine>().line().front();
        mouse(QEvent::MouseButtonPress, to);
        mouse(QEvent::MouseMove, to + QPointF(3, 17), Qt::ShiftModifier);
        QCOMPARE(window().find<ui::SectionLine>().line().back().y, start.y);
        mouse(QEvent::MouseMove, to + QPointF(-20, 17));
        mouse(QEvent::MouseButtonRelease, to + QPointF(-20, 17));
        QVERIFY(window().find<ui::SectionLine>().line().back().y < start.y);
        QVERIFY(same(view().section()->pieces, expected().pieces));
        const PointD end = window().find<ui::SectionLine>().line().back();
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, from + QPointF(10, 10));
        mouse(QEvent::MouseButtonRelease, from + QPointF(10, 10));
        QVERIFY(isAt(window().find<ui::SectionLine>().line().back(), end));
        QVERIFY(same(view().section()->pieces, expected().pieces));
    }

    void theLineIsPaintedOver2d() {
        const QImage before = flat().grabPicture()->copy();
        drawLine();
        QVERIFY(differingPixels(before, *flat().grabPicture()) > 300);
        window().find<ui::SectionPanel>().findChild<QAction*>()->trigger();  // Clear
        QCOMPARE(differingPixels(before, *flat().grabPicture()), 0);
        QVERIFY(!view().section());
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
        QVERIFY(std::abs(along().y + 1.0) < 0.01);
        window().actions()[ActionId::SectionPlane].trigger();
        QVERIFY(window().views().solid().cut() == nullptr);
    }

    void aLineBesideTheBoardIsTold() {
        const model::Box& board = m_index->board->board;
        const double x = board.max.x + 5e6;
        sections().cutAlong({{x, 0}, {x, 1e6}});
        QVERIFY(view().section()->pieces.empty());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("meets nothing"));
        sections().cutAlong({{2e9, 0}, {2e9, 1e6}});
        QVERIFY(!view().section());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("coordinates"));
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
        QVERIFY(!sections().save(path));  // nothing to export
        drawLine();
        QVERIFY(sections().save(path));
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
        QVERIFY(!sections().save("/nowhere/cut.svg"));
        QVERIFY(!sections().save("/nowhere/cut.pdf"));
        QVERIFY(sections().save(m_fixture->folder() + "/cut.pdf"));
        QFile pdf(m_fixture->folder() + "/cut.pdf");
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        const QRegularExpressionMatch size = QRegularExpression("width=\"([0-9.]+)mm\"").match(svg);
        const QRegularExpressionMatch page =
            QRegularExpression("/MediaBox \\[0 0 ([0-9.]+) ").match(QString::fromLatin1(pdf.readAll()));
        QVERIFY(size.hasMatch() && page.hasMatch());
        const double pointsPerMm = 72.0 / 25.4;
        QVERIFY(std::abs(size.captured(1).toDouble() * pointsPerMm - page.captured(1).toDouble()) < 1.0);
    }

    void theSheetOfAnUnrolledNetNamesIt() {
        const QString path = m_fixture->folder() + "/net.svg";
        for (std::size_t row = 0; row < m_index->board->nets.size() && !view().section(); ++row) {
            window().selection().setNets({{0, model::NetId{row}}});
            window().actions()[ActionId::SectionAlongNet].trigger();
        }
        QVERIFY(sections().save(path));
        const auto nets = window().selection().nets();
        const QString name = QString::fromStdString(m_index->board->nets[nets.front().net.row()].name);
        const auto text = [&] {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
        };
        QVERIFY(text().contains("section along net " + name.toHtmlEscaped() + ","));
        drawLine();
        QVERIFY(sections().save(path));
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

    void numbersBesideASectionAreWholeAndItsRowsInTheirOrder() {
        drawLine();
        QTRY_VERIFY(view().section().has_value());
        view().resize(300, 260);
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

    void sectionsAreKeptRenamedShownForgottenAndUndone() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(kept().empty());  // nothing to keep
        drawLine();
        const std::vector<PointD> line = window().find<ui::SectionLine>().line();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(kept().size(), std::size_t{1});
        QAbstractItemModel& names = *window().find<ui::SectionPanel>().list().model();
        QVERIFY(names.setData(names.index(0, 0), "Across"));
        QCOMPARE(kept()[0].name, std::string("Across"));
        QVERIFY(names.setData(names.index(0, 0), "  "));  // no name
        QCOMPARE(names.index(0, 0).data().toString(), QString("Across"));

        sections().cutAlong({});
        const QRect location = window().find<ui::SectionPanel>().list().visualRect(names.index(0, 0));
        QTest::mouseClick(window().find<ui::SectionPanel>().list().viewport(), Qt::LeftButton, {}, location.center());
        QVERIFY(isAt(window().find<ui::SectionLine>().line().front(), line.front()));
        QVERIFY(same(view().section()->pieces, expected().pieces));

        // As another run of the program finds them.
        const auto found = model::session::loadSession(m_board.toStdString(), *window().document());
        QVERIFY(found.ignored.empty());
        QCOMPARE(found.session.sections, kept());

        emit window().find<ui::SectionPanel>().forgotten(0);
        QVERIFY(kept().empty());
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(kept().size(), std::size_t{1});
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(kept()[0].name, std::string("Section 1"));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(names.rowCount(), 1);
        window().actions()[ActionId::Undo].trigger();
    }

    void aKeptSectionOfAnotherStepIsNotShown() {
        QVERIFY(m_fixture->openAndWait(m_board));
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(),
                                             {{"Far", "other", {{0, 0}, {1e6, 0}}}}));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(kept().size(), std::size_t{1});
        emit window().find<ui::SectionPanel>().chosen(0);
        QVERIFY(!view().section());
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(), {}));
    }

    /// As if the session file of another board lay beside this one.
    void keptSectionsOfAnotherBoardAreTold() {
        const std::string here = window().document()->job.step;
        QVERIFY(model::session::saveSections(
            m_board.toStdString(), *window().document(),
            {{"Theirs", "step of another job", {{0, 0}, {1e6, 0}}}, {"Beside", here, {{9e8, 9e8}, {9.1e8, 9e8}}}}));
        QVERIFY(m_fixture->openAndWait(m_board));
        QCOMPARE(kept().size(), std::size_t{2});
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        emit window().find<ui::SectionPanel>().chosen(0);
        QVERIFY(!view().section());
        QCOMPARE(reported.last()[0].toString(),
                 "Theirs is a section of step step of another job, which this board does not have");
        emit window().find<ui::SectionPanel>().chosen(1);
        QVERIFY(view().section() && view().section()->pieces.empty());
        QVERIFY(window().find<ui::SectionPanel>().notes().contains("meets nothing of the board"));
        QVERIFY(model::session::saveSections(m_board.toStdString(), *window().document(), {}));
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
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::SectionFeature& sections() { return window().sections(); }
    [[nodiscard]] ui::SectionView& view() { return window().find<ui::SectionPanel>().view(); }
    [[nodiscard]] BoardView& flat() { return window().views().flat(); }

    [[nodiscard]] const std::vector<model::session::SavedSection>& kept() { return window().sections().saved(); }
    static bool isAt(PointD a, PointD b) { return a.x == b.x && a.y == b.y; }
    static bool same(const std::vector<SectionPiece>& a, const std::vector<SectionPiece>& b) {
        return std::ranges::equal(a, b, [](const SectionPiece& p, const SectionPiece& q) {
            return p.layer == q.layer && p.at == q.at && p.from == q.from && p.to == q.to && p.bottom == q.bottom &&
                   p.top == q.top;
        });
    }
    /// What the line of the window cuts.
    [[nodiscard]] model::Section expected() {
        return *model::makeSection(*m_index, {window().find<ui::SectionLine>().line(), {}});
    }

    /// From one edge of the board to the other through its middle, in pixels of the 2D view.
    [[nodiscard]] std::pair<QPointF, QPointF> acrossBoard() {
        const model::Box& board = m_index->board->board;
        const double y = (double{1} * board.min.y + board.max.y) / 2;
        const auto at = [&](double x) {
            return *flat().controller().screenOf(window().probing().position().toModel({x, y}));
        };
        return {at(board.min.x), at(board.max.x)};
    }
    void drawLine() {
        const auto [from, to] = acrossBoard();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(view().section().has_value());
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
    void mouse(QEvent::Type type, QPointF at, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, flat().mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }

    void clickOn(QPointF at) {
        mouse(QEvent::MouseButtonPress, at);
        mouse(QEvent::MouseButtonRelease, at);
    }
    void hover(QPointF at) {
        QMouseEvent event(QEvent::MouseMove, at, flat().mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }
    void pressKey(Qt::Key key) {
        QKeyEvent event(QEvent::KeyPress, key, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_board;
    std::shared_ptr<const model::BoardIndex> m_index;
};

QTEST_MAIN(SectionFeatureTest)
#include "section_feature_test.moc"
