// The panels Parts and Pins in the window: both ways between rows and views, from a component to its nets and from a
// net to its components, filters, export, and boards that have none of it.

#include <QComboBox>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include "model/index/pin_names.h"
#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/parts/part_group_model.h"
#include "ui/parts/pin_model.h"
#include "ui/parts/pins_panel.h"

using model::BoardElement;
using ui::PartGroupModel;
using ui::PartModel;
using ui::PinModel;

class PartsPanelTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().actions()[ui::ActionId::ShowPartsDock].trigger();
        window().actions()[ui::ActionId::ShowPinsDock].trigger();
        QVERIFY(parts().isVisible() && pins().isVisible());
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aRowSelectsItsComponentAndListsItsPins() {
        const int row = rowOf(parts(), "U1");
        click(parts(), row);
        QCOMPARE(selectedIds(), finder().elementsOf(component("U1")));
        QVERIFY(window().label("elementHeading").startsWith("Component U1: 9 pins on "));
        QVERIFY(window().label("pinsOf").startsWith("U1: 9 pins on "));
        QCOMPARE(pins().model()->rowCount(), 9);
        QCOMPARE(text(pins(), 0, PinModel::Pin), "U1.1");
        QCOMPARE(rowsOf(parts()), QStringList{"U1"});
        const float before = window().views().flat().controller().mmPerPixel();
        QTest::keyClick(&parts(), Qt::Key_Return);
        QVERIFY(window().views().flat().controller().mmPerPixel() != before);
    }

    void theMenuOfARowSelectsAndShowsItsComponent() {
        const QModelIndex row = parts().model()->index(rowOf(parts(), "U1"), 0);
        parts().scrollTo(row);
        const QPoint cell = parts().visualRect(row).center();
        const float before = window().views().flat().controller().mmPerPixel();
        QTest::mouseClick(parts().viewport(), Qt::RightButton, {}, cell);
        QCOMPARE(selectedIds(), finder().elementsOf(component("U1")));
        QStringList entries;
        QTimer::singleShot(0, this, [&entries] {
            auto* open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            for (QAction* action : open != nullptr ? open->actions() : QList<QAction*>()) {
                entries += action->text().remove('&');
                if (action->objectName() == QLatin1String("show")) {
                    action->trigger();
                }
            }
            if (open != nullptr) {
                open->close();
            }
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, cell, parts().viewport()->mapToGlobal(cell));
        QApplication::sendEvent(parts().viewport(), &event);
        QVERIFY(window().views().flat().controller().mmPerPixel() != before);
        for (const char* entry : {"Show", "Highlight net", "Save selection"}) {
            QVERIFY2(entries.contains(QLatin1String(entry)), qPrintable(entries.join(", ")));
        }
    }

    void namesAreWholeWhereTheTableHasRoom() {
        PartModel model;
        ui::LinkedTable table(model);
        constexpr int kNarrow = 40;
        table.setColumnWidth(PartModel::Part, kNarrow);
        table.giveRoom({PartModel::Part});
        table.horizontalHeader()->setStretchLastSection(true);
        model.setBoard(window().workspace().board()->document);
        table.resize(3'000, 300);
        table.show();
        int widest = 0;
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString name = model.index(row, PartModel::Part).data().toString();
            widest = std::max(widest, table.fontMetrics().horizontalAdvance(name));
        }
        QVERIFY(widest > kNarrow);
        QTRY_VERIFY(table.columnWidth(PartModel::Part) >= widest);
        table.resize(400, 300);
        QTRY_COMPARE(table.columnWidth(PartModel::Part), kNarrow);
        table.horizontalHeader()->resizeSection(PartModel::Part, 77);
        table.resize(3'000, 300);
        QTest::qWait(50);
        QVERIFY2(table.columnWidth(PartModel::Part) == 77, "set by hand");
    }

    void severalRowsSelectSeveralComponents() {
        click(parts(), rowOf(parts(), "U1"));
        click(parts(), rowOf(parts(), "J6"), Qt::ControlModifier);
        std::vector<model::ElementId> both = finder().elementsOf(component("U1"));
        std::ranges::copy(finder().elementsOf(component("J6")), std::back_inserter(both));
        std::ranges::sort(both);
        QCOMPARE(selectedIds(), both);
        QVERIFY(window().label("pinsOf").startsWith("2 components: "));
        parts().setFocus();
        QTest::keyClick(&parts(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(window().selection().title(), QString("%1 components").arg(window().document()->components.size()));
    }

    void aPadInAViewMarksItsComponentAndItsPin() {
        const model::PinId pin = pinAlone();
        const QString name = QString::fromStdString(model::fullPinName(*window().document(), pin));
        window().selection().select({{0, finder().elementsOf(pin).front()}});
        QCOMPARE(rowsOf(parts()), QStringList{name.section('.', 0, 0)});
        QCOMPARE(rowsOf(pins()), QStringList{name});
        QCOMPARE(parts().currentIndex().row(), rowOf(parts(), name.section('.', 0, 0)));
        QVERIFY(pins().model()->rowCount() > 1);
        window().selection().select({});
        QVERIFY(rowsOf(parts()).isEmpty() && rowsOf(pins()).isEmpty());
    }

    void aNetListsItsPinsAndThePinsStayWhileTheyAreChosen() {
        const model::NetId net = window().document()->findNet("1PPS_OUT");
        window().selection().setNets({{0, net}});
        const auto count = std::ranges::count(window().document()->pins, net, &model::Pin::net);
        QCOMPARE(pins().model()->rowCount(), static_cast<int>(count));
        QVERIFY(window().label("pinsOf").startsWith(QString("1PPS_OUT: %1 pins of ").arg(count)));
        const QString first = text(pins(), 0, PinModel::Pin);
        click(pins(), 0);
        QCOMPARE(window().selection().title(), "Pin " + first);
        QCOMPARE(pins().model()->rowCount(), static_cast<int>(count));
        QCOMPARE(rowsOf(pins()), QStringList{first});
        QCOMPARE(rowsOf(parts()), QStringList{first.section('.', 0, 0)});
    }

    void thePinsOfAComponentLeadToItsNets() {
        click(parts(), rowOf(parts(), "U1"));
        window().findChild<QToolButton*>("highlightNetsOfPins")->click();
        QCOMPARE(window().selection().nets().size(),
                 model::netsOf(*window().document(), window().document()->components[component("U1").row()]).size());
        QCOMPARE(pins().model()->rowCount(), 9);
    }

    void filteringChangesNothingElse() {
        click(parts(), rowOf(parts(), "U1"));
        const auto before = window().selection().selected();
        auto* filter = window().findChild<QLineEdit*>("partFilter");
        filter->setFocus();
        QTest::keyClicks(filter, "j6");
        QCOMPARE(parts().model()->rowCount(), 1);
        QVERIFY(
            window().label("partsShown").startsWith(QString("1 of %1").arg(window().document()->components.size())));
        QCOMPARE(window().selection().selected(), before);
        QVERIFY2(!QRegularExpression("[0-9]{2,} without").match(window().label("partsShown")).hasMatch(),
                 qPrintable(window().label("partsShown")));  // of one row, not of the board
        QTest::keyClick(filter, Qt::Key_Escape);
        QVERIFY(filter->text().isEmpty() && filter->hasFocus());
        QTest::keyClick(filter, Qt::Key_Escape);
        QVERIFY(!filter->hasFocus());
        QCOMPARE(rowsOf(parts()), QStringList{"U1"});
    }

    void allPinsAreListedWhileNothingIsChosen() {
        QCOMPARE(pins().model()->rowCount(), static_cast<int>(window().document()->pins.size()));
        auto* filter = window().findChild<QLineEdit*>("pinFilter");
        filter->setFocus();
        QTest::keyClicks(filter, "u1.4");
        QCOMPARE(text(pins(), 0, PinModel::Pin), "U1.4");
        QCOMPARE(text(pins(), 0, PinModel::Layer), "L01-TOP_LAYER to L04-BOTTOM_LAYER");  // it goes through
    }

    void rowsBecomeAFile() {
        const QList<QByteArray> lines = exportedLines();
        QCOMPARE(lines.size(), static_cast<qsizetype>(window().document()->components.size()) + 1);
        QVERIFY(lines.front().startsWith("Designator,"));
    }

    void theColumnIsCalledByTheChosenAttribute() {
        auto& attribute = *window().findChild<QComboBox*>("partAttribute");
        const auto heading = [&] { return parts().model()->headerData(PartModel::Attributes, Qt::Horizontal); };
        QVERIFY(attribute.count() > 1);
        for (int row = 1; row < attribute.count(); ++row) {
            attribute.setCurrentIndex(row);
            QCOMPARE(heading().toString(), attribute.itemText(row));
            QCOMPARE(groups().model()->headerData(PartGroupModel::Attributes, Qt::Horizontal), heading());
        }
        attribute.setCurrentIndex(0);
        QCOMPARE(heading().toString(), "Attributes");
    }

    void theBillOfMaterialsHasValuesOnce() {
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/everything"));
        auto& attribute = *window().findChild<QComboBox*>("partAttribute");
        const int value = attribute.findText("value", Qt::MatchFixedString);
        QVERIFY(value > 0);
        attribute.setCurrentIndex(value);
        QTest::mouseClick(window().findChild<QToolButton*>("groupParts"), Qt::LeftButton);
        QCOMPARE(exportedLines().front(), QByteArray("Quantity,Part,Value,Package,Fitted,Step,Designators"));
    }

    void aTableThatIsSortedBeginsAtItsTop() {
        click(parts(), parts().model()->rowCount() - 1);
        QVERIFY(parts().verticalScrollBar()->value() > 0);
        const QHeaderView& header = *parts().horizontalHeader();
        const QPoint heading(header.sectionViewportPosition(PartModel::Designator) + 20, header.height() / 2);
        QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, heading);
        QCOMPARE(header.sortIndicatorSection(), static_cast<int>(PartModel::Designator));
        QCOMPARE(parts().verticalScrollBar()->value(), 0);
    }

    void anotherBoardBeginsAtTheTop() {
        const QScrollBar& bar = *parts().verticalScrollBar();
        parts().scrollToBottom();
        const int bottom = bar.value();
        QVERIFY(bottom > 0);
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(bar.value(), bottom);
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/boards/opencellular_breakout.tgz"));
        QVERIFY(bar.maximum() > 0);
        QCOMPARE(bar.value(), 0);
    }

    void aTableThatIsNotSeenDoesNotFollow() {
        QAction& shown = window().actions()[ui::ActionId::ShowPartsDock];
        const std::vector<ui::BoardPart> part{{0, component("U1")}};
        shown.trigger();
        QVERIFY(!parts().isVisible());
        window().find<ui::PartPicking>().select(part);
        window().selection().select({});
        shown.trigger();
        QTRY_VERIFY(parts().isVisible());
        QCOMPARE(parts().verticalScrollBar()->value(), 0);
        shown.trigger();
        window().find<ui::PartPicking>().select(part);
        shown.trigger();
        QTRY_COMPARE(rowsOf(parts()), QStringList{"U1"});
        QVERIFY(parts().verticalScrollBar()->value() > 0);
    }

    void equalPartsBecomeOneRow() {
        const auto count = static_cast<int>(window().document()->components.size());
        QTest::mouseClick(window().findChild<QToolButton*>("groupParts"), Qt::LeftButton);
        QVERIFY(groups().isVisible() && !parts().isVisible());
        QVERIFY(groups().model()->rowCount() < count);
        const int row = rowWithSeveral();
        QVERIFY(row >= 0);
        const QStringList names = text(groups(), row, PartGroupModel::Designators).split(", ");
        QCOMPARE(text(groups(), row, PartGroupModel::Quantity), QString::number(names.size()));
        click(groups(), row);
        QCOMPARE(window().selection().title(), QString("%1 components").arg(names.size()));
        std::vector<model::ElementId> elements;
        for (const QString& name : names) {
            std::ranges::copy(finder().elementsOf(component(qPrintable(name))), std::back_inserter(elements));
        }
        std::ranges::sort(elements);
        elements.erase(std::ranges::unique(elements).begin(), elements.end());
        QCOMPARE(selectedIds(), elements);
        window().selection().select({});
        QVERIFY(groups().selectionModel()->selectedRows().isEmpty());
        window().find<ui::PartPicking>().select(std::vector{ui::BoardPart{0, component(qPrintable(names.last()))}});
        QCOMPARE(groups().selectionModel()->selectedRows().front().row(), row);
        QTest::mouseClick(window().findChild<QToolButton*>("groupParts"), Qt::LeftButton);
        QCOMPARE(rowsOf(parts()), QStringList{names.last()});
    }

    void theBillOfMaterialsIsFilteredAndBecomesAFile() {
        QTest::mouseClick(window().findChild<QToolButton*>("groupParts"), Qt::LeftButton);
        const int all = groups().model()->rowCount();
        const int row = rowWithSeveral();
        const QString designators = text(groups(), row, PartGroupModel::Designators);
        const qsizetype count = designators.count(',') + 1;
        auto* filter = window().findChild<QLineEdit*>("partFilter");
        filter->setText(text(groups(), row, PartGroupModel::Part) + ' ' + designators.section(", ", -1));
        QCOMPARE(groups().model()->rowCount(), 1);
        QVERIFY2(window()
                     .label("partsShown")
                     .startsWith(QString("1 of %1 parts · %2 of %3 components")
                                     .arg(all)
                                     .arg(count)
                                     .arg(window().document()->components.size())),
                 qPrintable(window().label("partsShown")));
        const QList<QByteArray> lines = exportedLines();
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith("Quantity,Part,Value,Package,"));
        QVERIFY(lines[1].startsWith(QByteArray::number(count) + ','));
        QVERIFY(lines[1].endsWith(",\"" + designators.toUtf8() + '"'));
    }

    /// In the narrow panels that the window begins with.
    void numbersAndHeadingsAreWhole() {
        for (ui::TableView* table : {&parts(), &pins()}) {
            for (int column = 0; column < table->model()->columnCount(); ++column) {
                if (table->isColumnHidden(column)) {
                    continue;
                }
                const QString heading = table->model()->headerData(column, Qt::Horizontal).toString();
                const auto isWide = [&](int needed) { return table->columnWidth(column) >= needed; };
                QTRY_VERIFY2(isWide(table->horizontalHeader()->sectionSizeHint(column)), qPrintable(heading));
                const QModelIndex first = table->model()->index(0, column);
                if ((first.data(ui::TableModel::kTraitsRole).toInt() & ui::kNumber) != 0) {
                    QTRY_VERIFY2(isWide(table->sizeHintForIndex(first).width()), qPrintable(heading));
                }
            }
        }
    }

    void placesThatTheJobDoesNotSayAreMarked() {
        model::Component placed;
        placed.refdes = "R1";
        model::Component unplaced;
        unplaced.refdes = "R2";
        unplaced.isPlaced = false;
        auto board = std::make_shared<model::Document>();
        board->components = {placed, unplaced};
        PartModel parts;
        parts.setBoard(board);
        const auto shows = [&](int row, int column, int role) { return parts.index(row, column).data(role); };
        for (const int column : {PartModel::X, PartModel::Y}) {
            QVERIFY(!shows(0, column, Qt::FontRole).value<QFont>().italic());
            QVERIFY(shows(1, column, Qt::FontRole).value<QFont>().italic());
            QCOMPARE(shows(1, column, Qt::DisplayRole), shows(0, column, Qt::DisplayRole));
        }
        QVERIFY(!shows(0, PartModel::Rotation, Qt::DisplayRole).toString().isEmpty());
        QCOMPARE(shows(1, PartModel::Rotation, Qt::DisplayRole).toString(), QString());
        QVERIFY(shows(1, PartModel::X, Qt::ToolTipRole).toString().contains("the middle of its pins"));
        QVERIFY(!shows(0, PartModel::X, Qt::ToolTipRole).toString().contains("the middle of its pins"));
        QVERIFY(parts.missing({0, 1}).contains("1 without a place"));
    }

    void pinsAreListedOnceTheyAreSeen() {
        window().actions()[ui::ActionId::ShowPinsDock].trigger();
        QVERIFY(!pins().isVisible());
        const int before = pins().model()->rowCount();
        window().selection().select({{0, finder().elementsOf(pinAlone()).front()}});
        QCOMPARE(pins().model()->rowCount(), before);
        window().actions()[ui::ActionId::ShowPinsDock].trigger();
        QTRY_VERIFY(pins().model()->rowCount() != before);
        QCOMPARE(rowsOf(pins()).size(), 1);
    }

    void boardsWithoutComponentsSaySo() {
        QVERIFY(m_fixture->openAndWait(QString(locations::kTestData) + "/odb/negative"));
        QCOMPARE(window().label("partsShown"), "The job has no components");
        QCOMPARE(window().label("pinsOf"), "The job has no pins of components");
        window().selection().setNets({{0, model::NetId{std::size_t{0}}}});
        QVERIFY2(window().label("pinsOf").contains(": no pins"), qPrintable(window().label("pinsOf")));
    }

private:
    /// Of the table that is shown; empty if there is no file.
    QList<QByteArray> exportedLines() {
        const QString path = m_fixture->folder() + "/table.csv";
        window().findChild<QToolButton*>("exportParts")->click();
        window().nameFile(path);
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n') : QList<QByteArray>();
    }
    TestWindow& window() { return m_fixture->window(); }
    ui::TableView& parts() { return window().table("parts"); }
    ui::TableView& groups() { return *window().panel("parts").findChildren<ui::TableView*>().last(); }
    ui::TableView& pins() { return window().table("pins"); }
    const model::PinFinder& finder() { return window().find<ui::PartPicking>().finderOf(0); }

    model::ComponentId component(const char* refdes) {
        const auto& all = window().document()->components;
        return model::ComponentId{
            static_cast<std::size_t>(std::ranges::find(all, refdes, &model::Component::refdes) - all.begin())};
    }
    /// The first one of a component of several whose pad is no other component's.
    model::PinId pinAlone() {
        model::PinId pin{std::size_t{0}};
        const auto& components = window().document()->components;
        const auto isAlone = [&] {
            const auto elements = finder().elementsOf(pin);
            return components[window().document()->pins[pin.row()].component.row()].pinCount > 1 && !elements.empty() &&
                   finder().pinsOf(elements.front()).size() == 1;
        };
        while (!isAlone()) {
            ++pin.value;
        }
        return pin;
    }
    std::vector<model::ElementId> selectedIds() {
        std::vector<model::ElementId> ids;
        for (const BoardElement& at : window().selection().selected()) {
            ids.push_back(at.element);
        }
        return ids;
    }
    static QString text(ui::TableView& table, int row, int column) {
        return table.model()->index(row, column).data().toString();
    }
    static int rowOf(ui::TableView& table, const QString& name) {
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            if (text(table, row, 0) == name) {
                return row;
            }
        }
        return -1;
    }
    int rowWithSeveral() {
        for (int row = 0; row < groups().model()->rowCount(); ++row) {
            if (groups().model()->index(row, PartGroupModel::Quantity).data(Qt::EditRole).toInt() > 2) {
                return row;
            }
        }
        return -1;
    }
    static QStringList rowsOf(ui::TableView& table) {
        QStringList names;
        for (const QModelIndex& index : table.selectionModel()->selectedRows()) {
            names += index.data().toString();
        }
        return names;
    }
    static void click(ui::TableView& table, int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QModelIndex index = table.model()->index(row, 0);
        table.scrollTo(index);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, modifiers, table.visualRect(index).center());
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(PartsPanelTest)
#include "parts_panel_test.moc"
