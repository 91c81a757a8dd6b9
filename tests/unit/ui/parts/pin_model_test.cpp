#include "ui/parts/pin_model.h"

#include <QtTest>
#include <numeric>

#include "tests/unit/model/hand_made.h"

using ui::BoardPin;
using ui::PinModel;

class PinModelTest : public QObject {
    Q_OBJECT

private slots:
    void rowsOfPinsAreFoundAmongThoseListed() {
        PinModel model;
        model.setBoard(boardOf(4));
        model.setPins({pin(3), pin(1), pin(0)});
        QCOMPARE(model.rowsOf({}), std::vector<int>());
        QCOMPARE(model.rowsOf({pin(3), pin(0), pin(2)}), (std::vector{0, 2}));  // in the order of rows
        model.setAllPins();
        QCOMPARE(model.rowsOf({pin(3), pin(2)}), (std::vector{2, 3}));
    }

    /// As many as may be selected at once: row by row for each of them this is half a minute and more.
    void rowsOfAllPinsTakeNoTime() {
        constexpr std::size_t kPins = ui::PartPicking::kMostElements;
        PinModel model;
        model.setBoard(boardOf(kPins));
        model.setAllPins();
        std::vector<BoardPin> all;
        for (std::size_t row = kPins; row-- > 0;) {
            all.push_back(pin(row));
        }
        std::vector<int> rows(kPins);
        std::iota(rows.begin(), rows.end(), 0);
        QCOMPARE(model.rowsOf(std::move(all)), rows);
    }

private:
    static BoardPin pin(std::size_t row) { return {0, model::PinId{row}}; }

    /// A component with so many pins and no copper.
    static ui::LoadedBoard boardOf(std::size_t pins) {
        model::DocumentBuilder builder;
        builder.addComponent({}, std::vector<model::Pin>(pins));
        ui::LoadedBoard board;
        board.document = builder.finish();
        board.index = hand_made::indexed(board.document);
        return board;
    }
};

QTEST_APPLESS_MAIN(PinModelTest)
#include "pin_model_test.moc"
