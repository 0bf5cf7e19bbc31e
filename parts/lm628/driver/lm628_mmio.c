/* SPDX-License-Identifier: Apache-2.0 */
#include "lm628_mmio.h"

#include <stddef.h>

static void store(const lm628_mmio *mmio, uintptr_t address, uint32_t value) {
  if (mmio->store != NULL) {
    mmio->store(mmio->context, address, value);
  } else if (mmio->bits == 8) {
    *(volatile uint8_t *)address = (uint8_t)value;
  } else if (mmio->bits == 16) {
    *(volatile uint16_t *)address = (uint16_t)value;
  } else {
    *(volatile uint32_t *)address = value;
  }
}

static uint32_t load(const lm628_mmio *mmio, uintptr_t address) {
  if (mmio->load != NULL) return mmio->load(mmio->context, address);
  if (mmio->bits == 8) return *(volatile uint8_t *)address;
  if (mmio->bits == 16) return *(volatile uint16_t *)address;
  return *(volatile uint32_t *)address;
}

static void mmio_write(void *context, bool ps, uint8_t byte) {
  const lm628_mmio *mmio = context;
  store(mmio, ps ? mmio->data : mmio->command, byte);
}

static uint8_t mmio_read(void *context, bool ps) {
  const lm628_mmio *mmio = context;
  return (uint8_t)(load(mmio, ps ? mmio->data : mmio->command) & 0xFFu);
}

static void mmio_strobe_reset(void *context) {
  const lm628_mmio *mmio = context;
  store(mmio, mmio->reset, 1);
}

static void mmio_wait_us(void *context, uint32_t us) {
  const lm628_mmio *mmio = context;
  mmio->wait_us(mmio->context, us);
}

static bool is_aligned(const lm628_mmio *mmio, uintptr_t address) {
  return address % (mmio->bits / 8u) == 0;
}

lm628_error lm628_mmio_port(lm628_port *port, lm628_mmio *mmio) {
  if (port == NULL || mmio == NULL || mmio->wait_us == NULL) return LM628_ERROR_NULL;
  if ((mmio->load == NULL) != (mmio->store == NULL)) return LM628_ERROR_NULL;
  if (mmio->bits != 8 && mmio->bits != 16 && mmio->bits != 32) return LM628_ERROR_RANGE;
  if (mmio->command == mmio->data || !is_aligned(mmio, mmio->command) ||
      !is_aligned(mmio, mmio->data) || (mmio->has_reset && !is_aligned(mmio, mmio->reset))) {
    return LM628_ERROR_RANGE;
  }
  port->write = mmio_write;
  port->read = mmio_read;
  port->strobe_reset = mmio->has_reset ? mmio_strobe_reset : NULL;
  port->wait_us = mmio_wait_us;
  port->context = mmio;
  return LM628_OK;
}
