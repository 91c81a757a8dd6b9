#include "ui/layers/layer_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QUndoStack>
#include <QtTest>

#include "tests/unit/ui/sample_document.h"
#include "ui/common/table_text.h"
#include "ui/layers/layer_step.h"

using ui::LayerAppearance;
using ui::LayerModel;

namespace {

std::vector<LayerAppearance> sampleStyles() {
    return {{Qt::red, 100, true}, {Qt::blue, 100, true}, {Qt::gray, 100, false}, {Qt::yellow, 60, true}};
}

/// Three copper layers; holes through all of them, and from the middle to the bottom.
std::shared_ptr<const model::Document> drilledDocument() {
    using namespace model;
    DocumentBuilder builder;
    const auto addLayer = [&](const char* name, LayerType type, std::size_t from, std::size_t to) {
        Layer layer;
        layer.name = name;
        layer.type = type;
        layer.spanTop = type == LayerType::Drill ? LayerId{from} : LayerId{};
        layer.spanBottom = type == LayerType::Drill ? LayerId{to} : LayerId{};
        builder.beginLayer(builder.addLayer(layer));
    };
    addLayer("top", LayerType::Signal, 0, 0);
    addLayer("middle", LayerType::Signal, 0, 0);
    addLayer("bottom", LayerType::Signal, 0, 0);
    addLayer("through", LayerType::Drill, 0, 2);
    addLayer("buried", LayerType::Drill, 1, 2);
    return builder.finish();
}

QString visibleRows(const LayerModel& model) {
    QString rows;
    for (const LayerAppearance& look : model.effectiveStyles()) {
        rows += look.isVisible ? '1' : '0';
    }
    return rows;
}

}  // namespace

class LayerModelTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_model.setDocument(sampleDocument(), sampleStyles()); }

    void listsEveryLayerOfTheDocument() {
        QCOMPARE(ui::tableText(m_model),
                 "Show\tColour\tLayer\tType\tOpacity\tSolo\n"
                 "yes\t#ff0000\ttop\tSignal\t100\tno\n"
                 "yes\t#0000ff\tbottom\tSignal\t100\tno\n"
                 "no\t#a0a0a4\tnotes\tDocument\t100\tno\n"
                 "yes\t#ffff00\t(outline)\tBoard outline\t60\tno\n");
    }

    void isEmptyWithoutADocument() {
        m_model.setDocument(nullptr, {});
        QCOMPARE(m_model.rowCount(), 0);
        m_model.showAll();
        QVERIFY(m_model.effectiveStyles().empty());
    }

    void checkMarkHidesALayerAndSaysSoOnce() {
        QSignalSpy changed(&m_model, &LayerModel::stylesChanged);
        QVERIFY(m_model.setData(m_model.index(0, LayerModel::Visible), Qt::Unchecked, Qt::CheckStateRole));
        QCOMPARE(visibleRows(m_model), "0101");
        QCOMPARE(changed.count(), 1);
    }

    void soloShowsOneLayerAndGivesBackTheRest() {
        m_model.toggleSolo(model::LayerId{std::size_t{2}});
        QCOMPARE(visibleRows(m_model), "0010");
        m_model.toggleSolo(model::LayerId{std::size_t{1}});
        QCOMPARE(visibleRows(m_model), "0100");
        m_model.toggleSolo(model::LayerId{std::size_t{1}});
        QCOMPARE(visibleRows(m_model), "1101");
    }

    void copperShownAloneHasTheHolesThroughItThatAreChecked() {
        m_model.setDocument(drilledDocument(), std::vector<LayerAppearance>(5, {Qt::red, 100, true}));
        m_model.toggleSolo(model::LayerId{std::size_t{0}});
        QCOMPARE(visibleRows(m_model), "10010");
        m_model.toggleSolo(model::LayerId{std::size_t{1}});
        QCOMPARE(visibleRows(m_model), "01011");
        m_model.setData(m_model.index(3, LayerModel::Visible), Qt::Unchecked, Qt::CheckStateRole);
        m_model.toggleSolo(model::LayerId{std::size_t{0}});
        QCOMPARE(visibleRows(m_model), "10000");
    }

    void soloCheckMarkMovesFromRowToRow() {
        m_model.setData(m_model.index(0, LayerModel::Solo), Qt::Checked, Qt::CheckStateRole);
        m_model.setData(m_model.index(1, LayerModel::Solo), Qt::Checked, Qt::CheckStateRole);
        QCOMPARE(m_model.index(0, LayerModel::Solo).data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
        QCOMPARE(m_model.index(1, LayerModel::Solo).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
        m_model.setData(m_model.index(0, LayerModel::Solo), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(visibleRows(m_model), "0100");
        m_model.setData(m_model.index(1, LayerModel::Solo), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(visibleRows(m_model), "1101");
    }

    void groupCommandsSetVisibilityAndEndSolo() {
        m_model.toggleSolo(model::LayerId{std::size_t{2}});
        m_model.showCopperOnly();
        QCOMPARE(visibleRows(m_model), "1100");
        m_model.showAll();
        QCOMPARE(visibleRows(m_model), "1111");
        m_model.hideAll();
        QCOMPARE(visibleRows(m_model), "0000");
        m_model.restoreDefaults();
        QCOMPARE(visibleRows(m_model), "1101");
    }

    void editsAreToldWithWhatUndoNeeds() {
        QUndoStack history;
        connect(&m_model, &LayerModel::edited, &history,
                [&](const ui::LayerEdit& edit) { history.push(new ui::LayerStep(m_model, edit)); });
        m_model.setData(m_model.index(0, LayerModel::Visible), Qt::Unchecked, Qt::CheckStateRole);
        m_model.showCopperOnly();
        m_model.showCopperOnly();  // changes nothing
        m_model.setData(m_model.index(1, LayerModel::Colour), QColor(1, 2, 3), Qt::EditRole);
        QCOMPARE(history.count(), 3);
        history.undo();
        QCOMPARE(m_model.effectiveStyles()[1].colour, QColor(Qt::blue));
        history.undo();
        QCOMPARE(visibleRows(m_model), "0101");
        history.undo();
        QCOMPARE(visibleRows(m_model), "1101");
        history.redo();
        QCOMPARE(visibleRows(m_model), "0101");
        QCOMPARE(history.count(), 3);
    }

    void aDragIsOneStepAndNoneIfItEndsWhereItBegan() {
        QUndoStack history;
        connect(&m_model, &LayerModel::edited, &history,
                [&](const ui::LayerEdit& edit) { history.push(new ui::LayerStep(m_model, edit)); });
        const auto drag = [this](int row, int percent) {
            m_model.setData(m_model.index(row, LayerModel::Opacity), percent, Qt::EditRole);
        };
        drag(0, 80);
        drag(0, 30);
        drag(1, 50);
        QCOMPARE(history.count(), 2);
        drag(1, 100);
        QCOMPARE(history.count(), 1);
        history.undo();
        QCOMPARE(m_model.effectiveStyles()[0].opacityPercent, 100);
    }

    void undoKeepsThePaletteThatWasChosenSince() {
        QUndoStack history;
        connect(&m_model, &LayerModel::edited, &history,
                [&](const ui::LayerEdit& edit) { history.push(new ui::LayerStep(m_model, edit)); });
        m_model.hideAll();
        auto other = sampleStyles();
        other[0].colour = Qt::magenta;
        m_model.setDefaults(other);
        history.undo();
        QCOMPARE(visibleRows(m_model), "1101");
        QCOMPARE(m_model.effectiveStyles()[0].colour, QColor(Qt::magenta));
    }

    void defaultSetRestoresVisibilityAlone() {
        m_model.setData(m_model.index(1, LayerModel::Colour), QColor(1, 2, 3), Qt::EditRole);
        m_model.showAll();
        m_model.showDefaultSet();
        QCOMPARE(visibleRows(m_model), "1101");
        QCOMPARE(m_model.effectiveStyles()[1].colour, QColor(1, 2, 3));
    }

    void opacityStaysBetweenNothingAndAll() {
        const QModelIndex cell = m_model.index(3, LayerModel::Opacity);
        QCOMPARE(cell.data().toString(), "60 %");
        QVERIFY(m_model.setData(cell, 250, Qt::EditRole));
        QCOMPARE(cell.data(Qt::EditRole).toInt(), 100);
        QVERIFY(m_model.setData(cell, -1, Qt::EditRole));
        QCOMPARE(m_model.effectiveStyles()[3].opacityPercent, 0);
    }

    void colourIsEditedAndOtherCellsAreNot() {
        QVERIFY(m_model.setData(m_model.index(1, LayerModel::Colour), QColor(1, 2, 3), Qt::EditRole));
        QCOMPARE(m_model.effectiveStyles()[1].colour, QColor(1, 2, 3));
        QVERIFY(!m_model.setData(m_model.index(1, LayerModel::Colour), QColor(), Qt::EditRole));
        QVERIFY(!m_model.setData(m_model.index(1, LayerModel::Name), "x", Qt::EditRole));
        QVERIFY(!m_model.setData({}, "x", Qt::EditRole));
    }

    void restoreDefaultsUndoesEveryEdit() {
        m_model.setData(m_model.index(1, LayerModel::Colour), QColor(1, 2, 3), Qt::EditRole);
        m_model.setData(m_model.index(1, LayerModel::Opacity), 10, Qt::EditRole);
        m_model.restoreDefaults();
        QCOMPARE(m_model.effectiveStyles(), sampleStyles());
    }

    void tipTellsThicknessAndItsSource() {
        const QString tip = m_model.index(0, LayerModel::Name).data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains("35 µm") && tip.contains("assumed") && tip.contains("1201 elements"), qPrintable(tip));
        m_model.setUnit(ui::LengthUnit::Mil);
        const QString inMil = m_model.index(0, LayerModel::Name).data(Qt::ToolTipRole).toString();
        QVERIFY2(inMil.contains("1.38 mil thick") && !inMil.contains("µm"), qPrintable(inMil));
    }

private:
    LayerModel m_model;
    QAbstractItemModelTester m_tester{&m_model, QAbstractItemModelTester::FailureReportingMode::QtTest};
};

QTEST_GUILESS_MAIN(LayerModelTest)
#include "layer_model_test.moc"
