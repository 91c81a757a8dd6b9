// Names on copper in the 2D view, those of copies of steps too.
#include "ui/views/plan_painter.h"

#include <QtTest>
#include <algorithm>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using model::BoardElement;

class PlanPainterTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/panel"));
        window().views().setArrangement(ui::Arrangement::Flat);
        window().views().flat().controller().look(render::NamedView::Top);
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    /// Beside each other, rotated, mirrored, flipped, and within others.
    void copperOfCopiesHasNames() {
        const std::vector<model::StepCopy>& copies = tree().copies;
        QVERIFY(std::ranges::any_of(copies, &model::StepCopy::isFlipped));
        int named = 0;
        for (std::uint32_t copy = 1; copy < copies.size(); ++copy) {
            for (const BoardElement& pad : padsOf(copy)) {
                window().layers().showOnly({copies[copy].isFlipped ? "BOTTOM" : "TOP"});
                lookAt(pad);
                QTRY_VERIFY2(isNamed(pad, "A"), qPrintable(QString::number(copy)));
                ++named;
            }
        }
        QVERIFY(named > 6);
    }

    void hiddenNetsOfCopiesHaveNone() {
        window().layers().showOnly({"TOP"});
        const auto isUpright = [&](std::uint32_t copy) { return !tree().copies[copy].isFlipped; };
        std::uint32_t copy = 1;
        while (!isUpright(copy) || padsOf(copy).empty()) {
            ++copy;
        }
        const BoardElement pad = padsOf(copy).front();
        lookAt(pad);
        QTRY_VERIFY(isNamed(pad, "A"));
        window().netStyles().setState({{*window().selection().netOf(pad), std::nullopt, true}});
        QVERIFY(!isNamed(pad, "A"));
        window().netStyles().setState({});
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    const model::StepTree& tree() { return window().selection().tree(); }

    /// On the top of its step, of a net.
    std::vector<BoardElement> padsOf(std::uint32_t copy) {
        const model::Document& step = *tree().steps[tree().copies[copy].step];
        const model::LayerId top = window().document()->findLayer("TOP");
        std::vector<BoardElement> pads;
        for (std::size_t row = 0; row < step.elements.size(); ++row) {
            if (step.elements.layer[row] == top && step.elements.net[row].isValid()) {
                pads.push_back({copy, model::ElementId{row}});
            }
        }
        return pads;
    }
    model::Box boxOf(const BoardElement& at) {
        return tree().copies[at.copy].placement.boxOf(window().selection().stepOf(at).boxOf(at.element));
    }
    void lookAt(const BoardElement& at) {
        ui::BoardView& view = window().views().flat();
        const model::Box box = boxOf(at);
        view.controller().show(view.position().toModel(base::toDouble(box.min)),
                               view.position().toModel(base::toDouble(box.max)));
    }
    bool isNamed(const BoardElement& at, const QString& name) {
        const QPointF middle =
            window().views().flat().screenOf(base::toDouble(boxOf(at).middle())).value_or(QPointF(-1, -1));
        return std::ranges::any_of(window().find<ui::PlanPainter>().labels(), [&](const ui::PlanPainter::Label& label) {
            return label.text == name && QLineF(label.middle, middle).length() < 2.0;
        });
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(PlanPainterTest)
#include "plan_painter_test.moc"
