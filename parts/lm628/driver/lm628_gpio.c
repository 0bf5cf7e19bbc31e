/* SPDX-License-Identifier: Apache-2.0 */
#include "lm628_gpio.h"

#include <stddef.h>

/* [ns] */
#define SETUP 50u       /* of PS before a strobe: 30; of data before WR rises: 50 */
#define WRITE 100u      /* WR low */
#define HOLD 120u       /* of data after WR rises, and until the next access */
#define READ 180u       /* RD low until the data are valid */
#define READ_OFF 180u   /* RD high until the part has left the bus */
#define RESET_LOW 2000u /* 8 clocks of 6 MHz: 1334 */

#define REST (LM628_GPIO_CS | LM628_GPIO_RD | LM628_GPIO_WR | LM628_GPIO_RST)

static void set(const lm628_gpio *gpio, unsigned levels, uint32_t ns) {
  gpio->set_lines(gpio->context, (uint8_t)levels);
  gpio->wait_ns(gpio->context, ns);
}

/* CS low, PS as asked. */
static unsigned chosen(bool ps) { return (REST ^ LM628_GPIO_CS) | (ps ? LM628_GPIO_PS : 0u); }

static void gpio_write(void *context, bool ps, uint8_t byte) {
  const lm628_gpio *gpio = context;
  const unsigned levels = chosen(ps);
  set(gpio, levels, SETUP);
  gpio->drive_bus(gpio->context, byte);
  set(gpio, levels ^ LM628_GPIO_WR, WRITE);
  set(gpio, levels, HOLD);
  gpio->release_bus(gpio->context);
  set(gpio, REST, HOLD);
}

static uint8_t gpio_read(void *context, bool ps) {
  const lm628_gpio *gpio = context;
  const unsigned levels = chosen(ps);
  uint8_t byte;
  set(gpio, levels, SETUP);
  set(gpio, levels ^ LM628_GPIO_RD, READ);
  byte = gpio->read_bus(gpio->context);
  set(gpio, levels, SETUP);
  set(gpio, REST, READ_OFF);
  return byte;
}

static void gpio_strobe_reset(void *context) {
  const lm628_gpio *gpio = context;
  set(gpio, REST ^ LM628_GPIO_RST, RESET_LOW);
  set(gpio, REST, HOLD);
}

static void gpio_wait_us(void *context, uint32_t us) {
  const lm628_gpio *gpio = context;
  gpio->wait_ns(gpio->context, us * 1000u);
}

lm628_error lm628_gpio_port(lm628_port *port, lm628_gpio *gpio) {
  if (port == NULL || gpio == NULL || gpio->set_lines == NULL || gpio->drive_bus == NULL ||
      gpio->release_bus == NULL || gpio->read_bus == NULL || gpio->wait_ns == NULL) {
    return LM628_ERROR_NULL;
  }
  port->write = gpio_write;
  port->read = gpio_read;
  port->strobe_reset = gpio->has_reset ? gpio_strobe_reset : NULL;
  port->wait_us = gpio_wait_us;
  port->context = gpio;
  gpio->release_bus(gpio->context);
  set(gpio, REST, HOLD);
  return LM628_OK;
}
