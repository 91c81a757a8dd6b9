#include "ui/workspace/selection_model.h"

#include <QSignalSpy>
#include <QtTest>

#include "model/board/document_builder.h"

using model::BoardElement;
using model::BoardNet;
using model::ElementId;
using model::NetId;
using ui::SelectionModel;

namespace {

using Lists = std::vector<std::vector<ElementId>>;

/// Six pads: 0 to 2 on net A, 3 and 4 on net B, 5 on none.
std::shared_ptr<const model::Document> board() {
    model::DocumentBuilder builder;
    const NetId a = builder.addNet("A");
    const NetId b = builder.addNet("B");
    builder.beginLayer(builder.addLayer({}));
    for (const NetId net : {a, a, a, b, b, NetId{}}) {
        model::DocumentBuilder::Origin origin;
        origin.net = net;
        builder.addCircle({{0, 0}, 1000, 0}, origin);
    }
    return builder.finish();
}

BoardElement at(std::size_t row, std::uint32_t copy = 0) {
    return {copy, ElementId{row}};
}

std::vector<ElementId> rows(std::initializer_list<std::size_t> list) {
    std::vector<ElementId> ids;
    for (const std::size_t row : list) {
        ids.emplace_back(row);
    }
    return ids;
}

}  // namespace

class SelectionModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_model = std::make_unique<SelectionModel>();
        m_model->setBoard(board());
    }

    void everythingThatIsChosenStandsOutOnce() {
        m_model->setNearby({at(5), at(3)});
        m_model->setNets({{0, NetId{0}}});
        m_model->select({at(3), at(0)});
        QCOMPARE(m_model->highlight(), (Lists{rows({0, 1, 2, 3, 5})}));
        m_model->setNearby({});
        m_model->hover(at(4));  // is outlined, no more
        QCOMPARE(m_model->highlight(), (Lists{rows({0, 1, 2, 3})}));
    }

    void selectingReplacesAndTogglingChangesSides() {
        m_model->select({at(4), at(1), at(4)});
        QCOMPARE(m_model->selected(), (std::vector{at(1), at(4)}));
        QCOMPARE(m_model->current(), std::optional(at(4)));
        m_model->select({at(2), at(4)}, SelectionModel::Mode::Toggle);
        QCOMPARE(m_model->selected(), (std::vector{at(1), at(2)}));
        QVERIFY2(m_model->current() == at(2), "the current one is always selected");
        m_model->select({at(5)});
        QCOMPARE(m_model->selected(), (std::vector{at(5)}));
        m_model->select({at(5)}, SelectionModel::Mode::Toggle);
        QVERIFY(m_model->selected().empty() && !m_model->current());
    }

    void clearingTakesOneStepAtATime() {
        m_model->setNets({{0, NetId{1}}});
        m_model->select({at(0)});
        QVERIFY(m_model->clearStep());
        QVERIFY(m_model->selected().empty());
        QCOMPARE(m_model->nets().size(), std::size_t{1});
        QVERIFY(m_model->clearStep());
        QVERIFY(m_model->nets().empty());
        QVERIFY(!m_model->clearStep());
    }

    void netsToggle() {
        m_model->toggleNets({{0, NetId{1}}});
        m_model->toggleNets({{0, NetId{0}}});
        QCOMPARE(m_model->nets(), (std::vector<BoardNet>{{0, NetId{0}}, {0, NetId{1}}}));
        m_model->toggleNets({{0, NetId{1}}});
        QCOMPARE(m_model->nets(), (std::vector<BoardNet>{{0, NetId{0}}}));
    }

    void theSelectionIsWhatWasChosenLast() {
        const std::vector<BoardNet> a{{0, NetId{0}}};
        const std::vector<BoardNet> b{{0, NetId{1}}};
        QVERIFY(m_model->isEmpty());
        m_model->select({at(3), at(4), at(5)});
        QCOMPARE(m_model->selectionNets(), b);
        QCOMPARE(m_model->selectionElements(), (std::vector{at(3), at(4), at(5)}));
        m_model->setNets(a);
        QVERIFY2(m_model->selected().empty() && !m_model->current(), "nets take the place of elements");
        QCOMPARE(m_model->selectionNets(), a);
        QCOMPARE(m_model->selectionElements(), (std::vector{at(0), at(1), at(2)}));
        m_model->select({at(4)});
        QCOMPARE(m_model->nets(), a);
        QCOMPARE(m_model->selectionNets(), b);
        m_model->select({at(5)});
        QVERIFY2(m_model->selectionNets().empty(), "what is selected has no net");
        m_model->select({});
        QCOMPARE(m_model->selectionNets(), a);
        m_model->select({at(5)});
        m_model->setNets(a);
        QVERIFY2(m_model->selected().empty(), "chosen again, nets that are highlighted already are the selection too");
    }

    void thePointerCountsOnceItHasComeToAnotherElement() {
        m_model->hover(at(0));
        QCOMPARE(m_model->pointed(), std::optional(at(0)));
        m_model->select({at(3)});
        m_model->hover(at(0));
        QVERIFY2(!m_model->pointed(), "it rests where it was");
        QCOMPARE(m_model->pointedOrCurrent(), std::optional(at(3)));
        m_model->hover(at(1));
        QCOMPARE(m_model->pointedOrCurrent(), std::optional(at(1)));
        m_model->setNets({{0, NetId{1}}});
        QVERIFY(!m_model->pointed());
        QCOMPARE(m_model->pointedOrCurrent(), std::optional(at(1)));
        m_model->hover(std::nullopt);
        QVERIFY(!m_model->pointedOrCurrent());
    }

    void oneSignalPerChangeAndNoneWithout() {
        QSignalSpy changed(m_model.get(), &SelectionModel::highlightChanged);
        QSignalSpy hovered(m_model.get(), &SelectionModel::hoverChanged);
        m_model->hover(at(1));
        m_model->hover(at(1));
        QCOMPARE(hovered.count(), 1);
        m_model->select({at(0), at(1), at(2)});
        m_model->setNets({{0, NetId{0}}});
        m_model->setNets({{0, NetId{0}}, {0, NetId{0}}});
        QCOMPARE(changed.count(), 2);
        QSignalSpy selected(m_model.get(), &SelectionModel::selectionChanged);
        m_model->select({at(0)});
        m_model->setNets({{0, NetId{1}}});  // takes the element's place too
        QCOMPARE(selected.count(), 2);
        QCOMPARE(changed.count(), 4);
    }

    void elementsOfCopiesStandOutInTheirStep() {
        auto panel = std::make_shared<model::Document>();
        panel->steps = {board()};
        panel->instances = {{0, {}, false}, {0, {{5, 5}, 0.0, false}, false}};
        m_model->setBoard(panel);
        m_model->select({at(4, 2), at(1, 1)});
        QCOMPARE(m_model->highlight(), (Lists{rows({}), rows({1, 4})}));
        QCOMPARE(&m_model->stepOf(at(4, 2)), panel->steps[0].get());
    }

    void netsOfPlacedStepsStandOutThere() {
        auto panel = std::make_shared<model::Document>();
        panel->steps = {board()};
        panel->instances = {{0, {}, false}, {0, {{5, 5}, 0.0, false}, false}};
        m_model->setBoard(panel);
        const auto net = m_model->netOf(at(4, 2));
        QCOMPARE(net, std::optional(BoardNet{1, NetId{1}}));
        QVERIFY(!m_model->netOf(at(5, 1)));
        m_model->toggleNets({*net});
        QCOMPARE(m_model->highlight(), (Lists{rows({}), rows({3, 4})}));
    }

    void anotherBoardForgetsEverything() {
        m_model->hover(at(0));
        m_model->select({at(1)});
        m_model->setNets({{0, NetId{0}}});
        m_model->setBoard(nullptr);
        QVERIFY(!m_model->hovered() && m_model->selected().empty() && !m_model->current() && m_model->nets().empty());
        QVERIFY(m_model->highlight().empty());
    }

private:
    std::unique_ptr<SelectionModel> m_model;
};

QTEST_APPLESS_MAIN(SelectionModelTest)
#include "selection_model_test.moc"
