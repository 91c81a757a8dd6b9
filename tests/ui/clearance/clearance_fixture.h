#pragma once

#include <QComboBox>
#include <QLabel>
#include <QtTest>
#include <memory>

#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/clearance_panel.h"

/// The window with the sample board, and the panel of clearances with its controls by their names.
class ClearanceFixture {
protected:
    /// Once.
    void open() {
        m_fixture = std::make_unique<WindowFixture>();
        m_board = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(m_board));
    }

    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::ClearancePanel& panel() { return window().find<ui::ClearancePanel>(); }
    [[nodiscard]] QComboBox& box(const char* name) { return *panel().findChild<QComboBox*>(name); }
    [[nodiscard]] QString label(const char* name) { return panel().findChild<QLabel*>(name)->text(); }

    /// Searches for what the boxes say, by its key, and waits until it is done.
    void measure() {
        m_fixture->key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!window().workspace().isWorking());
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_board;
};
