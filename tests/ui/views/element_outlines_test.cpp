// What is outlined over the views: nothing on hidden layers, bodies at their own height, little of large planes.
#include "ui/views/element_outlines.h"

#include <QtTest>
#include <algorithm>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using model::ElementId;

class ElementOutlinesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanup() { window().selection().select({}); }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    /// So that the pointer need not wait for those of large areas; of each board anew.
    void largeOutlinesAreMadeBeforeTheyAreAskedFor() {
        const auto edges = [&] { return window().workspace().board()->index->figures->edgeCount(); };
        QTRY_VERIFY(edges() > 0);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        QTRY_VERIFY(edges() > 0);
    }

    void outlinesVanishWithTheirLayer() {
        ui::LayerModel& layers = window().layers();
        const model::LayerId top = topCopper();
        window().selection().select({{0, ElementId{board().layer(top).elements.first}}});
        for (const ui::BoardView* view : window().views().both()) {
            QVERIFY(!outlines().strokesOver(*view).lines().empty());
        }
        const QModelIndex row = layers.index(static_cast<int>(top.row()), 0);
        QVERIFY(layers.setData(row, Qt::Unchecked, Qt::CheckStateRole));
        for (const ui::BoardView* view : window().views().both()) {
            QVERIFY(outlines().strokesOver(*view).lines().empty());
        }
        QVERIFY(layers.setData(row, Qt::Checked, Qt::CheckStateRole));
        QVERIFY(!outlines().strokesOver(window().views().flat()).lines().empty());
    }

    void outlinesVanishWithTheirNet() {
        std::size_t row = board().layer(topCopper()).elements.first;
        while (!board().elements.net[row].isValid()) {
            ++row;
        }
        const model::BoardNet net{0, board().elements.net[row]};
        window().selection().select({{0, ElementId{row}}});
        const auto isOutlined = [&](const ui::BoardView* view) {
            return !outlines().strokesOver(*view).lines().empty();
        };
        for (const ui::BoardView* view : window().views().both()) {
            QTRY_VERIFY(isOutlined(view));
        }
        window().netStyles().setState({{net, std::nullopt, true}});
        for (const ui::BoardView* view : window().views().both()) {
            QVERIFY(!isOutlined(view));
        }
        window().netStyles().setState({});
        for (const ui::BoardView* view : window().views().both()) {
            QVERIFY(isOutlined(view));
        }
    }

    void bodiesHaveTheirOwnHeight() {
        QVERIFY(!board().bodies.empty());
        bool isAnyLower = false;
        for (const model::Body& body : board().bodies) {
            window().selection().hover(model::BoardElement{0, body.element});
            const auto [bottom, top] = outlines().hovered().heights.on({true, 0.0, 150e6});
            QCOMPARE(top - bottom, static_cast<double>(body.height));
            isAnyLower =
                isAnyLower || body.height < board().layer(board().elements.layer[body.element.row()]).thickness;
        }
        QVERIFY(isAnyLower);
        window().selection().hover(std::nullopt);
    }

    void theWorkOfEverySelectionIsBounded() {
        std::vector<model::BoardElement> all;
        for (std::size_t row = 0; row < ui::ElementOutlines::kMostOutlined; ++row) {
            all.push_back({0, ElementId{row}});
        }
        window().selection().select(all);
        QVERIFY(!outlines().selected().empty());
        for (const ui::BoardView* view : window().views().both()) {
            QVERIFY2(outlines().strokesOver(*view).lines().empty(), "they come after the frame of what is selected");
        }
        for (const ui::BoardView* view : window().views().both()) {
            QTRY_VERIFY(!outlines().strokesOver(*view).lines().empty());
            QVERIFY(outlines().strokesOver(*view).segmentCount() <= ui::OutlineStrokes::kMostSegments);
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    const model::Document& board() { return *window().document(); }
    model::LayerId topCopper() {
        const auto top = std::ranges::find_if(board().layers, [](const model::Layer& layer) {
            return layer.isCopper() && layer.side == model::LayerSide::Top && layer.elements.count > 0;
        });
        return model::LayerId{static_cast<std::size_t>(top - board().layers.begin())};
    }
    ui::ElementOutlines& outlines() { return window().find<ui::ElementOutlines>(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ElementOutlinesTest)
#include "element_outlines_test.moc"
