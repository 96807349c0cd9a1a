#include "widgets/help/manual_terms.h"

#include <QCoreApplication>

#include "engine/base/parameters.h"
#include "engine/operator/device_registry.h"
#include "engine/planning/planner.h"
#include "widgets/controls/action_catalogue.h"
#include "widgets/controls/diagnostic_text.h"
#include "widgets/help/manual_tables.h"

namespace glissade {
namespace {

/// A text of the window without its mnemonic.
QString readText(const QString& text) { return commandName(text).toHtmlEscaped(); }

QString uiHtml(const QString& text) { return QStringLiteral("<span class=\"ui\">%1</span>").arg(readText(text)); }

/// The text for an argument such as "PathPanel/Speed". Contexts of classes with Q_OBJECT include the namespace.
QString anyWindowText(const QString& argument) {
  const int slash = argument.indexOf(QLatin1Char('/'));
  if (slash < 0) return {};
  const QByteArray context = argument.left(slash).toUtf8();
  const QByteArray text = argument.mid(slash + 1).toUtf8();
  const QString inNamespace = QCoreApplication::translate("glissade::" + context, text);
  return uiHtml(inNamespace.toUtf8() != text ? inNamespace : QCoreApplication::translate(context, text));
}

QString parameterHtml(const QString& key) {
  const auto id = parameterByKey(key.toStdString());
  if (!id) return {};
  return QStringLiteral("<a href=\"parameters.html#%1\">%2</a>").arg(key, readText(engineText(specOf(*id).label)));
}

}  // namespace

QString ManualTerms::html(const QString& kind, const QString& argument) {
  const QString html = known(kind, argument);
  if (html.isEmpty()) problems_ << QStringLiteral("{%1:%2}").arg(kind, argument);
  return html;
}

QString ManualTerms::known(const QString& kind, const QString& argument) const {
  if (kind == QStringLiteral("table")) return manualTable(argument, facts_);
  if (kind == QStringLiteral("parameter")) return parameterHtml(argument);
  if (kind == QStringLiteral("panel")) {
    for (const ManualPanel& panel : facts_.panels) {
      if (panel.id != argument) continue;
      return QStringLiteral("<a href=\"panels.html#panel-%1\">%2</a>").arg(panel.id, readText(panel.title));
    }
    return {};
  }
  if (kind == QStringLiteral("strategy")) {
    const PlannerRegistry planners = makePlannerRegistry();
    const PlannerEntry* entry = planners.find(argument.toStdString());
    return entry != nullptr ? uiHtml(engineText(entry->label)) : QString();
  }
  if (kind == QStringLiteral("operator")) {
    const DeviceRegistry devices = makeDeviceRegistry();
    const DeviceEntry* entry = devices.find(argument.toStdString());
    return entry != nullptr ? uiHtml(engineText(entry->label)) : QString();
  }
  if (kind == QStringLiteral("ui")) return anyWindowText(argument);
  return actionHtml(kind, argument);
}

QString ManualTerms::actionHtml(const QString& kind, const QString& id) const {
  for (const ManualAction& action : facts_.actions) {
    if (action.id != id) continue;
    const QString keys = QStringLiteral("<kbd>%1</kbd>").arg(action.keys.toHtmlEscaped());
    if (kind == QStringLiteral("keys")) return action.keys.isEmpty() ? QString() : keys;
    if (kind == QStringLiteral("name")) return uiHtml(action.text);
    if (kind != QStringLiteral("action")) return {};
    const QString path = action.menu.isEmpty() ? action.text : action.menu + QStringLiteral(" > ") + action.text;
    return uiHtml(path) + (action.keys.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(keys));
  }
  return {};
}

}  // namespace glissade
