#include "ui/common/tool_button.h"

namespace ui {

QToolButton* toolButton(QAction& action) {
    auto* button = new QToolButton;
    button->setDefaultAction(&action);
    button->setAutoRaise(true);
    return button;
}

}  // namespace ui
