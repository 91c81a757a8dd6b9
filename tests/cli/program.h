#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonObject>
#include <QProcess>
#include <QSize>
#include <QtEndian>

#include "tests/locations.h"

/// The program as others call it.
namespace program {

struct Outcome {
    int exitCode = -1;
    QByteArray out;
    QByteArray err;
};

/// Waits for its end; -1 when it crashed.
inline Outcome outcomeOf(QProcess& process) {
    process.waitForFinished(300'000);
    const bool isNormal = process.exitStatus() == QProcess::NormalExit;
    return {isNormal ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// Runs the program and waits for its end.
inline Outcome copperscope(const QStringList& arguments, const QString& folder = {},
                           const QProcessEnvironment& environment = {}) {
    QProcess process;
    process.setProcessEnvironment(environment.isEmpty() ? QProcessEnvironment::systemEnvironment() : environment);
    if (!folder.isEmpty()) {
        process.setWorkingDirectory(folder);
    }
    process.start(locations::kProgram, arguments);
    return outcomeOf(process);
}

/// The same by a shell, which puts `around` around the program: a limit, or a file for its output.
inline Outcome copperscopeInShell(const QString& around, const QStringList& arguments) {
    QProcess process;
    const QString program = locations::kProgram;
    process.start("/bin/sh", QStringList{"-c", around.arg("\"$0\" \"$@\""), program} + arguments);
    return outcomeOf(process);
}

/// Width and height from a PNG's header, which is all that must be known here.
inline QSize pngSize(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray head = file.read(24);
    const auto number = [&](int at) {
        return static_cast<int>(qFromBigEndian<quint32>(reinterpret_cast<const uchar*>(head.constData()) + at));
    };
    return head.startsWith("\x89PNG") ? QSize(number(16), number(20)) : QSize();
}

/// The element of a list that must have one.
inline QJsonObject onlyOne(const QJsonValue& list) {
    const QJsonArray array = list.toArray();
    return array.size() == 1 ? array.first().toObject() : QJsonObject();
}

}  // namespace program
