#include "ui/clearance/system_user.h"

#include <pwd.h>
#include <unistd.h>

#include <QtGlobal>
#include <array>

namespace ui {

namespace {

constexpr std::size_t kMostBytes = 16'384;  ///< of a record; longer ones count as none

}  // namespace

QString userNameOf(const QString& record, const QString& login) {
    QString name = record.section(',', 0, 0).trimmed();
    name.replace('&', login.left(1).toUpper() + login.mid(1));
    return name.isEmpty() ? login : name;
}

QString systemUserName() {
    std::array<char, kMostBytes> text{};
    passwd record{};
    passwd* found = nullptr;
    if (getpwuid_r(getuid(), &record, text.data(), text.size(), &found) != 0 || found == nullptr) {
        return qEnvironmentVariable("USER");  // containers may run as a number that has no record
    }
    return userNameOf(QString::fromLocal8Bit(record.pw_gecos), QString::fromLocal8Bit(record.pw_name));
}

}  // namespace ui
