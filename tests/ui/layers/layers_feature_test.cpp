// Layers are shown in sets, and what is done to them is undone like every other edit.

#include <QApplication>
#include <QClipboard>
#include <QColorDialog>
#include <QInputDialog>
#include <QMenu>
#include <QSpinBox>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

#include "tests/ui/window_fixture.h"
#include "ui/layers/layer_sets.h"
#include "ui/theme/theme.h"

using ui::ActionId;

class LayersFeatureTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_job = QString::fromStdString(m_fixture->copyOfJob("everything").string());
        QVERIFY(m_fixture->openAndWait(m_job));
    }
    void cleanup() {
        ui::applyTheme(ui::Theme::System);
        QCOMPARE(validationErrorsOnClosing(m_fixture), 0U);
    }

    void hidingAndShowingIsUndone() {
        const std::vector<bool> before = window().layers().visibility();
        trigger(ActionId::HideAllLayers);
        trigger(ActionId::ShowInnerLayers);
        QVERIFY(window().layers().visibility() != before);
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>());
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().layers().visibility(), before);
    }

    void whatIsShownAloneIsAStepOfItsOwn() {
        const model::LayerId hidden = clickOn("BOTTOM", ui::LayerModel::Visible);
        const model::LayerId alone = clickOn("TOP", ui::LayerModel::Solo);
        QCOMPARE(window().layers().soloLayer(), alone);
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!window().layers().soloLayer().isValid());
        QVERIFY2(!window().layers().visibility()[hidden.row()], "one step each");
        clickOn("TOP", ui::LayerModel::Solo);
        clickOn("TOP", ui::LayerModel::Solo);  // over, and nothing is left of it
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(window().layers().visibility()[hidden.row()]);
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
    }

    /// 2D draws the current layer over the others.
    void noLayerIsCurrentAfterACommandOrTheDefaultSet() {
        for (const ActionId id : {ActionId::NoCurrentLayer, ActionId::ShowDefaultLayers}) {
            const model::LayerId inner = clickOn("BOTTOM", ui::LayerModel::Name);
            QCOMPARE(window().workspace().currentLayer(), inner);
            trigger(id);
            QVERIFY(!window().workspace().currentLayer().isValid());
        }
    }

    void showingOrHidingLayersEndsOneThatIsShownAlone() {
        const model::LayerId top = window().document()->findLayer("TOP");
        const model::LayerId bottom = window().document()->findLayer("BOTTOM");
        const auto alone = [this] { return window().layers().soloLayer(); };
        window().layers().toggleSolo(top);
        QCOMPARE(button().text(), QString("Only TOP"));
        m_fixture->key(Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(!alone().isValid() && isShown("bodies top") && isShown("BOTTOM"));
        window().layers().toggleSolo(top);
        clickOn("BOTTOM", ui::LayerModel::Visible);
        QVERIFY(!alone().isValid() && isShown("TOP") && !isShown("BOTTOM"));
        window().layers().toggleSolo(top);
        window().workspace().showLayer(top);
        QCOMPARE(alone(), top);
        trigger(ActionId::BottomCopper);
        QCOMPARE(alone(), bottom);
        window().workspace().showLayer(top);
        QVERIFY(!alone().isValid() && isShown("TOP"));
        trigger(ActionId::Undo);
        QCOMPARE(alone(), bottom);
    }

    /// Both steps merge with their like, and neither with the other.
    void theColourOfALayerAndAHighlightAreTwoSteps() {
        ui::LayerModel& layers = window().layers();
        const auto colour = [&layers](int row) { return layers.index(row, ui::LayerModel::Colour).data(Qt::EditRole); };
        for (int row = 0; row < 2; ++row) {
            const QVariant before = colour(row);
            QVERIFY(layers.setData(layers.index(row, ui::LayerModel::Colour), QColor(1, 2, 3), Qt::EditRole));
            window().selection().setNets({{0, model::NetId{std::size_t{0}}}});
            QVERIFY(layers.setData(layers.index(row, ui::LayerModel::Colour), QColor(4, 5, 6), Qt::EditRole));
            trigger(ActionId::Undo);
            QCOMPARE(colour(row).value<QColor>(), QColor(1, 2, 3));
            trigger(ActionId::Undo);
            QVERIFY(window().selection().nets().empty());
            QCOMPARE(colour(row).value<QColor>(), QColor(1, 2, 3));
            trigger(ActionId::Undo);
            QCOMPARE(colour(row), before);
        }
    }

    void ownSetsAreKeptWithTheBoardAndUndone() {
        window().layers().showOnly({"TOP"});
        sets().save("Mine & yours");
        trigger(ActionId::ShowDefaultLayers);
        QCOMPARE(button().text(), QString("Default set"));
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(m_job));
        choose("Mine && yours");
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"TOP"});
        QCOMPARE(button().text(), QString("Mine && yours"));
        sets().remove("Mine & yours");
        QVERIFY(sets().own().empty());
        trigger(ActionId::Undo);
        QCOMPARE(sets().own().size(), std::size_t{1});
    }

    void theProposedNameOfASetReplacesNone() {
        sets().save("Set 1");
        window().layers().showOnly({"TOP"});
        sets().save("Set 2");
        sets().remove("Set 1");
        window().layers().showOnly({"BOTTOM"});
        trigger(ActionId::SaveLayerSet);
        auto* dialog = window().findChild<QInputDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->accept();
        QCOMPARE(sets().own().size(), std::size_t{2});
        QCOMPARE(sets().own()[0].layers, std::vector<std::string>{"TOP"});
        QCOMPARE(window().statusBar()->currentMessage(), QString("Saved the layer set Set 3"));
        sets().save("Set 2");
        QCOMPARE(sets().own()[0].layers, std::vector<std::string>{"BOTTOM"});
        QCOMPARE(window().statusBar()->currentMessage(), QString("Replaced the layer set Set 2"));
    }

    void savedViewsOfferTheirLayers() {
        window().layers().showOnly({"TOP"});
        trigger(ActionId::SaveView);
        trigger(ActionId::ShowAllLayers);
        choose("View 1");
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"TOP"});
    }

    void boardColoursAreDrawnKeptAndUndone() {
        const auto mask = [this] {
            for (std::size_t row = 0; row < window().document()->layers.size(); ++row) {
                if (window().document()->layers[row].name == "SMT solder mask") {
                    return window().views().solid().styles()[row];
                }
            }
            return render::LayerStyle{};
        };
        const render::LayerStyle green = mask();
        QVERIFY(green.material == render::Material::Gloss);
        chooseBoardColour(0, "Blue");
        QVERIFY(mask().colour.b > 2.0F * mask().colour.g);
        chooseBoardColour(2, "Tin (HASL)");
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(m_job));
        QVERIFY(mask().colour.b > 2.0F * mask().colour.g);
        chooseBoardColour(0, "White");
        trigger(ActionId::Undo);
        QVERIFY(mask().colour.b > 2.0F * mask().colour.g);
        chooseBoardColour(0, "Default: Green");
        QVERIFY(mask().colour == green.colour);
        QCOMPARE(window().layers().boardColours().finish, std::optional(model::SurfaceFinish::Tin));
    }

    void menusThatAreFilledAnewDropTheOldOnes() {
        sets().save("Mine");
        QMenu& colours = *window().findChild<QToolButton*>("boardColours")->menu();
        QMenu& ofSets = *button().menu();
        for (int opening = 0; opening < 3; ++opening) {
            emit colours.aboutToShow();
            emit ofSets.aboutToShow();
        }
        QCOMPARE(colours.findChildren<QMenu*>().size(), 3);
        QCOMPARE(ofSets.findChildren<QMenu*>().size(), 1);
    }

    void commandsAboutTheCurrentLayerTakeOneWhereThereIsNone() {
        const model::LayerId top = window().document()->findLayer("TOP");
        const model::LayerId bottom = window().document()->findLayer("BOTTOM");
        for (const ActionId id : {ActionId::SoloLayer, ActionId::NextLayer, ActionId::Contrast}) {
            m_fixture->restart();
            QVERIFY(m_fixture->openAndWait(m_job));
            QVERIFY(!window().workspace().currentLayer().isValid());
            trigger(id);
            QCOMPARE(window().workspace().currentLayer(), top);
            QCOMPARE(window().layers().soloLayer().isValid(), id == ActionId::SoloLayer);
        }
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(m_job));
        window().selection().select({{0, elementOn(bottom)}});
        trigger(ActionId::SoloLayer);
        QCOMPARE(window().layers().soloLayer(), bottom);
    }

    void theCommandSaysWhichLayerIsShownAloneAsLongAsItIs() {
        const auto said = [this] { return window().statusBar()->currentMessage(); };
        window().selection().select({{0, elementOn(window().document()->findLayer("BOTTOM"))}});
        trigger(ActionId::SoloLayer);
        QCOMPARE(said(), QString("Only BOTTOM is shown. H again shows all."));
        trigger(ActionId::SoloLayer);
        QVERIFY2(!said().startsWith("Only"), qPrintable(said()));
        trigger(ActionId::KeysKiCad);
        trigger(ActionId::SoloLayer);
        QCOMPARE(said(), QString("Only BOTTOM is shown. Shift+H again shows all."));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().layers().soloLayer().isValid());
        QVERIFY2(!said().startsWith("Only"), qPrintable(said()));
    }

    void theLayerShownAloneIsTheCurrentOneAndStandsOut() {
        window().layersPanel().select(window().document()->findLayer("TOP"));
        trigger(ActionId::Contrast);
        const model::LayerId bottom = window().document()->findLayer("BOTTOM");
        window().layers().toggleSolo(bottom);
        QCOMPARE(window().workspace().currentLayer(), bottom);
        QVERIFY(isAloneInFlat(bottom));
    }

    void highContrastGoesOnWithTheLayerShownAlone() {
        const model::LayerId top = window().document()->findLayer("TOP");
        window().layersPanel().select(top);
        trigger(ActionId::Contrast);
        trigger(ActionId::SoloLayer);
        QVERIFY(isAloneInFlat(top));
        m_fixture->key(Qt::Key_PageDown);
        const model::LayerId next = window().layers().soloLayer();
        QVERIFY(next.isValid() && next != top);
        QVERIFY(isAloneInFlat(next));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().layers().soloLayer().isValid());
        const auto& styles = window().views().flat().styles();
        QCOMPARE(styles[next.row()].opacity, 1.0F);
        QVERIFY(styles[top.row()].opacity < 1.0F);
    }

    void aRightClickLeavesTheLayerThatIsShownAlone() {
        const model::LayerId alone = clickOn("TOP", ui::LayerModel::Solo);
        ui::TableView& table = window().layersPanel().table();
        const auto& rows = static_cast<ui::GroupedLayers&>(*table.model());
        const QModelIndex other = rows.mapFromSource(window().layers().index(
            static_cast<int>(window().document()->findLayer("BOTTOM").row()), ui::LayerModel::Name));
        table.scrollTo(other);
        QTest::mouseClick(table.viewport(), Qt::RightButton, {}, table.visualRect(other).center());
        QCOMPARE(window().layers().soloLayer(), alone);
        QCOMPARE(window().workspace().currentLayer(), alone);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(other).center());
        QVERIFY(window().layers().soloLayer() != alone);
    }

    void theMenuOfARowCopiesAllWithHeadings() {
        bool isInMenu = false;
        QTimer::singleShot(0, this, [&isInMenu] {
            QWidget* popup = QApplication::activePopupWidget();
            const auto* menu = qobject_cast<QMenu*>(popup);
            for (QAction* action : menu != nullptr ? menu->actions() : QList<QAction*>()) {
                if (action->text().remove('&') == QLatin1String("Copy all with headings")) {
                    action->trigger();
                    isInMenu = true;
                }
            }
            if (popup != nullptr) {
                popup->close();  // or else a test that fails waits for it
            }
        });
        QGuiApplication::clipboard()->clear();
        emit window().layersPanel().table().customContextMenuRequested({5, 5});
        QVERIFY(isInMenu);
        const QString copied = QGuiApplication::clipboard()->text();
        QVERIFY2(copied.contains("\tTOP\t"), qPrintable(copied));
        QCOMPARE(copied.count('\n'), window().layersPanel().rows().rowCount() + 1);
    }

    void enterInAnEditorIsAboutItsCellAlone() {
        ui::TableView& table = window().layersPanel().table();
        clickOn("TOP", ui::LayerModel::Colour);
        QPointer<QColorDialog> dialog = window().findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->reject();
        QTRY_VERIFY(dialog.isNull());
        const QModelIndex bar = cellOf("BOTTOM", ui::LayerModel::Opacity);
        table.scrollTo(bar);
        const QPoint at = table.visualRect(bar).center();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, at);
        auto* box = table.findChild<QSpinBox*>();
        QVERIFY(box != nullptr);
        box->selectAll();
        QTest::keyClicks(box, "60");
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_COMPARE(bar.data(Qt::EditRole).toInt(), 60);
        QTRY_VERIFY(!table.isEditing());
        QVERIFY(window().findChild<QColorDialog*>() == nullptr);
        // The next Enter is about the cell that was edited, too.
        QCOMPARE(table.currentIndex(), bar);
        QTest::keyClick(&table, Qt::Key_Return);
        QVERIFY(table.isEditing());
        QVERIFY(window().findChild<QColorDialog*>() == nullptr);
    }

    void emptyBoxesAreSeenInSelectedRows_data() {
        QTest::addColumn<ui::Theme>("theme");
        QTest::newRow("dark") << ui::Theme::Dark;
        QTest::newRow("light") << ui::Theme::Light;
    }
    void emptyBoxesAreSeenInSelectedRows() {
        QFETCH(ui::Theme, theme);
        ui::applyTheme(theme);
        clickOn("BOTTOM", ui::LayerModel::Visible);
        const QModelIndex cell = cellOf("BOTTOM", ui::LayerModel::Visible);
        ui::TableView& table = window().layersPanel().table();
        QVERIFY(table.selectionModel()->isRowSelected(cell.row()));
        QCOMPARE(cell.data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Unchecked));
        const QImage drawn = table.viewport()->grab(table.visualRect(cell)).toImage();
        const int y = drawn.height() / 2;
        const int ground = qGray(drawn.pixel(drawn.width() / 2, y));  // within the box
        int sides = 0;
        for (int x = 0; x < drawn.width(); ++x) {
            sides += std::abs(qGray(drawn.pixel(x, y)) - ground) > 100 ? 1 : 0;
        }
        QVERIFY2(sides >= 2, qPrintable(QString::number(sides)));
    }

    void layersThatDrawNothingAreGreyAndPassedOver() {
        const model::LayerId core = window().document()->findLayer("CORE1");
        window().layersPanel().select(core);  // unfolds its group
        const auto colourOf = [this](model::LayerId layer, ui::LayerModel::Column column) {
            return window().layers().index(static_cast<int>(layer.row()), column).data(Qt::ForegroundRole);
        };
        const model::LayerId top = window().document()->findLayer("TOP");
        for (const auto column : {ui::LayerModel::Visible, ui::LayerModel::Name, ui::LayerModel::Solo}) {
            QCOMPARE(colourOf(core, column), QVariant(QColor(Qt::gray)));
            QCOMPARE(colourOf(top, column), QVariant());
        }
        trigger(ActionId::ShowAllLayers);
        for (const bool isAlone : {false, true}) {
            window().layersPanel().select(top);
            if (isAlone) {
                trigger(ActionId::SoloLayer);
            }
            m_fixture->key(Qt::Key_PageDown);
            const model::LayerId next = window().layersPanel().currentLayer();
            QCOMPARE(QString::fromStdString(window().document()->layer(next).name), QString("Inner Plane"));
            QCOMPARE(window().layers().soloLayer(), isAlone ? next : model::LayerId{});
            m_fixture->key(Qt::Key_PageUp);
            QCOMPARE(window().layersPanel().currentLayer(), top);
        }
    }

    void kiCadsKeysGoToOuterCopper() {
        trigger(ActionId::KeysKiCad);
        m_fixture->key(Qt::Key_PageDown);
        const model::LayerId bottom = window().layersPanel().currentLayer();
        QVERIFY(bottom.isValid());
        m_fixture->key(Qt::Key_PageUp);
        QCOMPARE(window().layersPanel().currentLayer(), window().document()->findLayer("TOP"));
        QVERIFY(bottom > window().layersPanel().currentLayer());
    }

    void headingsTakeTheWholeRowHoweverGroupsAreFolded() {
        const ui::TableView& table = window().table("layers");
        const auto& rows = static_cast<const ui::GroupedLayers&>(*table.model());
        const auto areWide = [&] {
            for (int row = 0; row < rows.rowCount(); ++row) {
                if ((table.columnSpan(row, ui::LayerModel::Name) > 1) != rows.isHeading(row)) {
                    return false;
                }
            }
            return true;
        };
        QVERIFY(areWide() && rows.isHeading(0));
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          table.visualRect(rows.index(0, ui::LayerModel::Name)).center());
        QVERIFY(rows.isFolded(rows.groupAt(0)) && areWide());
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                          table.visualRect(rows.index(0, ui::LayerModel::Name)).center());
        QVERIFY(!rows.isFolded(rows.groupAt(0)) && areWide());
    }

    void theSwitchOfComponentsSaysWhatIsDrawn() {
        const QAction& action = window().actions()[ActionId::ShowComponents];
        auto* bar = window().findChild<QToolBar*>("toolbar");
        QWidget* button = bar->widgetForAction(&window().actions()[ActionId::ShowComponents]);
        QVERIFY(!action.isChecked() && !action.icon().isNull());
        QVERIFY(!isShown("bodies top"));
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY(action.isChecked());
        QVERIFY(isShown("bodies top"));
        m_fixture->key(Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(!action.isChecked());
        QVERIFY(!isShown("bodies top"));
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(action.isChecked());
        // Wherever the layers are hidden, the switch follows.
        trigger(ActionId::ShowCopperOnly);
        QVERIFY(!action.isChecked());
        trigger(ActionId::ShowAssemblyLayers);
        QVERIFY(action.isChecked());
    }

    void aBoardWithoutComponentsHasNothingToSwitch() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("drills").string())));
        trigger(ActionId::ShowComponents);
        QVERIFY(!window().actions()[ActionId::ShowComponents].isChecked());
    }

private:
    [[nodiscard]] bool isShown(const char* layer) {
        const std::vector<std::string> names = window().layers().visibleNames();
        return std::ranges::find(names, layer) != names.end();
    }
    /// But for the holes through it.
    [[nodiscard]] bool isAloneInFlat(model::LayerId layer) {
        const auto& styles = window().views().flat().styles();
        for (std::size_t row = 0; row < styles.size(); ++row) {
            if (styles[row].isVisible != (row == layer.row() || window().document()->layers[row].spans(layer))) {
                return false;
            }
        }
        return !styles.empty();
    }
    TestWindow& window() { return m_fixture->window(); }
    ui::LayerSets& sets() { return window().find<ui::LayerSets>(); }
    QToolButton& button() { return *window().findChild<QToolButton*>("layerSets"); }
    /// A cell of a layer in the panel.
    model::LayerId clickOn(const char* layer, ui::LayerModel::Column column) {
        ui::TableView& table = window().layersPanel().table();
        const model::LayerId id = window().document()->findLayer(layer);
        window().layersPanel().select(id);
        const QModelIndex cell = table.currentIndex().siblingAtColumn(column);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(cell).center());
        return id;
    }
    QModelIndex cellOf(const char* layer, ui::LayerModel::Column column) {
        const auto row = static_cast<int>(window().document()->findLayer(layer).row());
        return window().layersPanel().rows().mapFromSource(window().layers().index(row, column));
    }
    void trigger(ActionId id) { window().actions()[id].trigger(); }
    model::ElementId elementOn(model::LayerId layer) {
        const auto& layers = window().document()->elements.layer;
        return model::ElementId{static_cast<std::size_t>(std::ranges::find(layers, layer) - layers.begin())};
    }
    /// `part`: 0 = solder mask, 1 = silkscreen, 2 = finish.
    void chooseBoardColour(int part, const QString& text) {
        QMenu& menu = *window().findChild<QToolButton*>("boardColours")->menu();
        emit menu.aboutToShow();
        for (QAction* action : menu.actions()[part]->menu()->actions()) {
            if (action->text() == text) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(text + " is not offered"));
    }
    void choose(const QString& set) {
        QMenu& menu = *button().menu();
        emit menu.aboutToShow();
        for (QAction* action : menu.actions()) {
            if (action->text() == set) {
                action->trigger();
                return;
            }
        }
        QFAIL(qPrintable(set + " is not offered"));
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_job;
};

QTEST_MAIN(LayersFeatureTest)
#include "layers_feature_test.moc"
