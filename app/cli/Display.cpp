// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/Display.h"

#include <QCoreApplication>
#include <QLibrary>

namespace espalier {

namespace {

/// Whether an X server answers; also true if that cannot be found out.
bool xServerAnswers()
{
    using Connect = void* (*)(const char*, int*);
    using HasError = int (*)(void*);
    using Disconnect = void (*)(void*);
    QLibrary library(QStringLiteral("xcb"), 1);
    const auto connect = reinterpret_cast<Connect>(library.resolve("xcb_connect"));
    const auto hasError = reinterpret_cast<HasError>(library.resolve("xcb_connection_has_error"));
    const auto disconnect = reinterpret_cast<Disconnect>(library.resolve("xcb_disconnect"));
    if (!connect || !hasError || !disconnect)
        return true;
    void* connection = connect(nullptr, nullptr);
    const bool answers = hasError(connection) == 0;
    disconnect(connection);
    return answers;
}

} // namespace

QString displayProblem()
{
#ifdef Q_OS_LINUX
    const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
    const bool wantsX =
        platform.startsWith("xcb") || (platform.isEmpty() && !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"));
    if (!wantsX)
        return {};
    if (qEnvironmentVariableIsEmpty("DISPLAY"))
        return QCoreApplication::translate(
            "Display", "there is no display (DISPLAY is not set); xvfb-run provides a virtual one");
    if (!xServerAnswers())
        return QCoreApplication::translate("Display", "the display %1 does not answer")
            .arg(qEnvironmentVariable("DISPLAY"));
#endif
    return {};
}

bool isDisplayVirtual()
{
    return qEnvironmentVariableIntValue("ESPALIER_VIRTUAL_DISPLAY") != 0;
}

} // namespace espalier
