// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace espalier {

namespace {

const QString kLanguageName = QStringLiteral("language");

void install(const QLocale& locale, const QString& texts)
{
    auto* translator = new QTranslator(QCoreApplication::instance());
    translator->setObjectName(kLanguageName);
    if (translator->load(locale, texts, QStringLiteral("_"), QStringLiteral(":/translations")))
        QCoreApplication::installTranslator(translator);
}

} // namespace

void speakLanguage(const QString& code)
{
    // A translator that goes takes its texts along.
    qDeleteAll(
        QCoreApplication::instance()->findChildren<QTranslator*>(kLanguageName, Qt::FindDirectChildrenOnly));
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    QLocale::setDefault(locale);
    install(locale, QStringLiteral("espalier"));
    install(locale, QStringLiteral("qtbase"));
}

} // namespace espalier
