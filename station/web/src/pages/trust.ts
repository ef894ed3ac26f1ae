// The page of this machine's certificate.

import "./door.css";

import { makeTrust } from "../door/trust";

await makeTrust();
