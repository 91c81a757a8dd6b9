#pragma once

#include <QWidget>
#include <map>
#include <string>
#include <vector>

#include "ui/workspace/settings.h"

class QComboBox;
class QLineEdit;

namespace ui {

/// Which nets are exported: all, those of the selection, or some that are typed.
class ExportNets : public QWidget {
    Q_OBJECT

public:
    enum Which { All, OfSelection, Typed };

    /// Names as the job has them: of all nets, and of those of the selection.
    ExportNets(const std::vector<std::string>& all, std::vector<std::string> selected, QWidget* parent = nullptr);

    /// Names as the job has them; empty: all nets.
    [[nodiscard]] std::vector<std::string> nets() const;
    /// Why there is nothing to go by; empty: there is.
    [[nodiscard]] QString problem() const;
    /// As the last time, where this board has such nets.
    void restore(const Settings& settings);
    /// What does not apply is disabled and exports all nets, as it then says; what was chosen comes back.
    void setApplied(bool isApplied);
    void remember(Settings& settings) const;

signals:
    void changed();

private:
    [[nodiscard]] int which() const;
    /// Also while that does not apply.
    [[nodiscard]] int chosen() const { return isEnabled() ? which() : m_chosen; }
    /// Between commas, without what is no net of the board, which `problem` names.
    [[nodiscard]] std::vector<std::string> typed(QString* problem = nullptr) const;
    void completeNames();

    std::vector<std::string> m_selected;
    std::map<QString, std::string> m_nets;  ///< by name in the job, and by what people type
    QComboBox* m_which;
    int m_chosen = All;  ///< while it does not apply
    QLineEdit* m_names;
};

}  // namespace ui
