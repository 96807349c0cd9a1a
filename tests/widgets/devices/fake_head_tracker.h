#pragma once

#include <QUdpSocket>

#include <array>
#include <vector>

namespace glissade::test {

/// Sends datagrams to a port of this machine: those of OpenTrack, or any bytes.
class FakeHeadTracker {
 public:
  explicit FakeHeadTracker(int port) : port_(static_cast<quint16>(port)) {}

  /// Sends centimetres and degrees.
  void send(const std::array<double, 6>& numbers) {
    socket_.writeDatagram(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers), QHostAddress::LocalHost,
                          port_);
  }
  void sendBytes(const std::vector<char>& bytes) {
    socket_.writeDatagram(bytes.data(), static_cast<qint64>(bytes.size()), QHostAddress::LocalHost, port_);
  }

 private:
  QUdpSocket socket_;
  quint16 port_;
};

}  // namespace glissade::test
