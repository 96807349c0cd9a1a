#include "widgets/devices/head_receiver.h"

#include <array>

namespace glissade {
namespace {

/// Most datagrams that are read before the window's other events.
constexpr int kMostAtOnce = 200;

}  // namespace

bool HeadReceiver::open(int port, bool fromAnywhere) {
  close();
  dropped_ = 0;
  auto socket = std::make_unique<QUdpSocket>();
  const QHostAddress address(fromAnywhere ? QHostAddress::AnyIPv4 : QHostAddress::LocalHost);
  if (!socket->bind(address, static_cast<quint16>(port), QAbstractSocket::DontShareAddress)) {
    trouble_ = socket->errorString();
    return false;
  }
  trouble_.clear();
  socket_ = std::move(socket);
  connect(socket_.get(), &QUdpSocket::readyRead, this, &HeadReceiver::read);
  return true;
}

void HeadReceiver::read() {
  std::optional<HeadReading> newest;
  // The buffer is one byte longer than a datagram of opentrack, so that longer datagrams are noticed.
  std::array<std::byte, kOpentrackBytes + 1> datagram;
  for (int i = 0; i < kMostAtOnce && hasMore(); ++i) {
    const qint64 size = socket_->readDatagram(reinterpret_cast<char*>(datagram.data()), datagram.size());
    if (size < 0) continue;
    const auto reading = parseOpentrack(std::span(datagram).first(static_cast<std::size_t>(size)));
    if (reading) {
      newest = reading;
    } else {
      ++dropped_;
    }
  }
  if (newest) emit received(*newest);
  if (hasMore()) QMetaObject::invokeMethod(this, &HeadReceiver::read, Qt::QueuedConnection);
}

}  // namespace glissade
